// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/maps/passed_voxels.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace ribbon_mapper {
namespace {

using Corners = std::array<Eigen::Vector3f, 3>;

std::map<MapVoxel, int> visits_of(const Corners& corners) {
  std::map<MapVoxel, int> visits;
  for_each_voxel_of_triangle(corners, [&](const MapVoxel& voxel) { ++visits[voxel]; });
  return visits;
}

/// Returns whether the plane of a triangle meets a voxel, grown by a little.
bool plane_meets(const Corners& corners, const MapVoxel& voxel) {
  const Eigen::Vector3f normal =
      (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  const Eigen::Vector3f centre =
      Eigen::Vector3f(static_cast<float>(voxel[0]), static_cast<float>(voxel[1]),
                      static_cast<float>(voxel[2])) +
      Eigen::Vector3f::Constant(0.5F);
  return std::abs(normal.dot(centre - corners[0])) <= 0.5F * normal.cwiseAbs().sum() + 1e-3F;
}

TEST(TriangleVoxels, HoldAllPointsButThoseNearTheEdges) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(-40.0F, 40.0F), weight(0.0F, 1.0F);
  for (int round = 0; round < 50; ++round) {
    Corners corners;
    for (auto& corner : corners) corner = {place(random), place(random), place(random)};
    const auto visits = visits_of(corners);
    for (const auto& [voxel, count] : visits) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(plane_meets(corners, voxel));
    }
    const Eigen::Vector3f middle = (corners[0] + corners[1] + corners[2]) / 3.0F;
    for (int i = 0; i < 200; ++i) {
      Eigen::Vector3f w(weight(random), weight(random), weight(random));
      w /= w.sum();
      const Eigen::Vector3f point = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
      // Shrunk to points whose whole column lies within the triangle.
      const Eigen::Vector3f inner = middle + 0.5F * (point - middle);
      const float area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
      if (area < 500.0F) continue;
      EXPECT_EQ(visits.count(voxel_at(inner)), 1U) << inner.transpose();
    }
  }
}

TEST(TriangleVoxels, TwoTrianglesShareNoColumn) {
  const Eigen::Vector3f a(0.0F, 0.0F, 0.5F), b(20.3F, 1.7F, 0.5F), c(18.0F, 15.1F, 0.5F),
      d(-3.0F, 11.9F, 0.5F);
  auto visits = visits_of({a, b, c});
  for (const auto& [voxel, count] : visits_of({a, c, d})) visits[voxel] += count;
  for (const auto& [voxel, count] : visits) EXPECT_EQ(count, 1) << voxel[0] << " " << voxel[1];
}

TEST(TriangleVoxels, ATriangleWithoutAreaHasNone) {
  const Eigen::Vector3f a(0.0F, 0.0F, 0.0F), b(5.0F, 5.0F, 5.0F);
  EXPECT_TRUE(visits_of({a, b, b}).empty());
  EXPECT_TRUE(visits_of({a, a, a}).empty());
}

TEST(WayVoxels, FollowTheWayToItsEnd) {
  std::vector<MapVoxel> voxels;
  for_each_voxel_of_way({0.5F, 0.5F, 0.5F}, {-3.5F, 2.5F, 0.5F},
                        [&](const MapVoxel& voxel) { voxels.push_back(voxel); });
  ASSERT_EQ(voxels.size(), 4U);
  EXPECT_EQ(voxels.front(), (MapVoxel{0, 0, 0}));
  EXPECT_EQ(voxels.back(), (MapVoxel{-3, 2, 0}));
}

TEST(VoxelGrid, KeepsBytesOnBothSidesOfZero) {
  VoxelGrid grid;
  const std::vector<MapVoxel> voxels{{0, 0, 0}, {-1, -1, -1}, {-17, 16, 300}, {70000, -70000, 5}};
  for (std::size_t i = 0; i < voxels.size(); ++i) grid.at(voxels[i]) = std::uint8_t(i + 1);
  for (std::size_t i = 0; i < voxels.size(); ++i) EXPECT_EQ(grid[voxels[i]], i + 1);
  EXPECT_EQ((grid[{1, 0, 0}]), 0);
  std::map<MapVoxel, int> visited;
  grid.for_each([&](const MapVoxel& voxel, std::uint8_t value) { visited[voxel] = value; });
  ASSERT_EQ(visited.size(), voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    EXPECT_EQ(visited[voxels[i]], static_cast<int>(i) + 1);
  }
}

}  // namespace
}  // namespace ribbon_mapper
