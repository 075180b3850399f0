// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/voxel_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ribbon_mapper {
namespace {

using Vector = Eigen::Vector3d;
using Slots = std::vector<std::uint32_t>;

constexpr double kVoxel_m = 0.5;
constexpr CubeSides kAllSides = (1 << kCubeSides) - 1;

Vector random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> in(-3.0, 3.0);
  return {in(random), in(random), in(random)};
}

/// Returns true if two points lie in the same voxel or in neighbouring ones.
bool are_neighbours(const Vector& a, const Vector& b) {
  const Vector va = (a / kVoxel_m).array().floor(), vb = (b / kVoxel_m).array().floor();
  return (va - vb).cwiseAbs().maxCoeff() <= 1.0;
}

/// Returns the ascending slots near a point that are listed for a side.
Slots near(VoxelIndex& index, const Vector& point, int side = 0) {
  Slots slots;
  const auto all = [](std::uint32_t) { return true; };
  index.near({index.voxel_at(point)}, side, all, slots);
  std::sort(slots.begin(), slots.end());
  return slots;
}

TEST(VoxelIndex, FindsHypothesesInTheVoxelAndItsNeighbours) {
  std::mt19937 random(8);
  VoxelIndex index(kVoxel_m);
  std::vector<std::vector<Vector>> points(30);
  for (std::uint32_t slot = 0; slot < 30; ++slot) {
    Slots keys;
    for (int i = 0; i < 5; ++i) {
      points[slot].push_back(random_point(random));
      keys.push_back(index.voxel_at(points[slot].back()));
    }
    index.list(slot, kAllSides);
    index.enter(slot, keys);
  }
  for (int i = 0; i < 500; ++i) {
    const Vector point = random_point(random);
    Slots slow;
    for (std::uint32_t slot = 0; slot < 30; ++slot) {
      const auto& own = points[slot];
      const auto is_near = [&](const Vector& other) { return are_neighbours(other, point); };
      if (std::any_of(own.begin(), own.end(), is_near)) slow.push_back(slot);
    }
    EXPECT_EQ(slow, near(index, point));
  }
}

TEST(VoxelIndex, ReturnsTheVoxelsOfARemovedHypothesis) {
  VoxelIndex index(kVoxel_m);
  index.list(0, 1), index.list(1, 1);
  index.enter(0, {index.voxel_at({0.1, 0.1, 0.1})});
  index.enter(1, {index.voxel_at({2.1, 0.1, 0.1}), index.voxel_at({2.6, 0.1, 0.1})});
  index.enter(0, index.remove(1));
  EXPECT_EQ(Slots{0}, near(index, {0.1, 0.1, 0.1}));
  EXPECT_EQ(Slots{0}, near(index, {2.6, 0.1, 0.1}));
  EXPECT_EQ(3u, index.touched_by(0).size());
  EXPECT_TRUE(index.touched_by(1).empty());
}

TEST(VoxelIndex, FindsHypothesesForTheirSidesOnly) {
  VoxelIndex index(kVoxel_m);
  const std::vector<std::uint32_t> here{index.voxel_at({0.1, 0.1, 0.1})};
  index.list(0, 1 << 2);
  index.enter(0, here);
  EXPECT_TRUE(near(index, {0.1, 0.1, 0.1}, 3).empty());
  index.list(0, 1 << 3);
  EXPECT_EQ(Slots{0}, near(index, {0.1, 0.1, 0.1}, 3));
  EXPECT_EQ(Slots{0}, near(index, {0.1, 0.1, 0.1}, 2));
  EXPECT_EQ(Slots{0},
            near(index, {-0.1, 0.1, 0.1}, 3));  // a voxel created after the slot was entered
}

TEST(CubeSides, ContainAllDirectionsWithinReach) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  const auto direction = [&] { return Vector(noise(random), noise(random), noise(random)); };
  constexpr double reach = 0.15;
  int more_than_one = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector a = direction().normalized();
    const CubeSides sides = cube_sides_within(a, reach);
    more_than_one += (sides & (sides - 1)) != 0;
    for (int k = 0; k < 50; ++k) {
      const Vector b = (a + reach * direction().normalized()).normalized();
      if ((a - b).norm() > reach) continue;
      EXPECT_TRUE(sides & (1 << cube_side(b)));
    }
  }
  EXPECT_LT(more_than_one, 1000);  // of 2000: most sets must be small to be of use
}

TEST(VoxelIndex, FindsNothingFarAway) {
  VoxelIndex index(kVoxel_m);
  index.list(0, kAllSides);
  index.enter(0, {index.voxel_at({0.1, 0.1, 0.1})});
  EXPECT_TRUE(near(index, {-400.0, 30.0, 2.0}).empty());
  EXPECT_TRUE(near(index, {1.1, 0.1, 0.1}).empty());
  EXPECT_EQ(Slots{0}, near(index, {-0.1, -0.1, -0.1}));
}

}  // namespace
}  // namespace ribbon_mapper
