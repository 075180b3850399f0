// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/observations/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

const Vector kX = Vector::UnitX(), kY = Vector::UnitY(), kZ = Vector::UnitZ();

/// Returns the number of indices below `end`.
std::size_t count_before(const std::vector<std::uint32_t>& indices, std::size_t end) {
  return static_cast<std::size_t>(
      std::count_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < end; }));
}

TEST(Thinned, KeepsAllOfFewRibbons) {
  Scene scene;
  scene.add(patch({0, 0, 0}, kX, kY));
  EXPECT_EQ(26u, thinned(scene.observations(), 26).size());
  EXPECT_EQ(20u, thinned(scene.observations(), 20).size());
}

TEST(Thinned, RemovesRibbonsWhereMostSeeTheSame) {
  Scene scene;
  scene.add(patch({0, 0, 0}, kX, kY));  // seen once
  const std::size_t once = scene.ribbons.size();
  for (int visit = 0; visit < 20; ++visit) scene.add(patch({5, 0, 0}, kX, kY));
  const auto kept = thinned(scene.observations(), once * 5);
  EXPECT_EQ(once * 5, kept.size());
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(once, count_before(kept, once));
}

TEST(Thinned, SeparatesTheSidesOfAWall) {
  Scene scene;
  scene.add(patch({2.0, 0, 0}, kY, kZ));
  const std::size_t once = scene.ribbons.size();
  for (int visit = 0; visit < 20; ++visit) scene.add(patch({2.02, 0, 0}, kZ, kY));
  EXPECT_EQ(once, count_before(thinned(scene.observations(), once * 5), once));
}

TEST(Thinned, KeepsALongRibbonThatSeesMoreThanOthers) {
  Scene scene;
  scene.ribbons.push_back(ribbon_between({0, 0.5, 0}, {4, 0.5, 0}, kZ));
  for (int visit = 0; visit < 20; ++visit) scene.add(patch({0, 0, 0}, kX, kY));
  const auto kept = thinned(scene.observations(), 60);
  EXPECT_EQ(0u, kept.front());
}

/// Each removal counts: where most ribbons were, no fewer are left than elsewhere.
TEST(Thinned, EvensOutHowOftenPlacesAreSeen) {
  Scene scene;
  const std::vector<std::size_t> visits{40, 25, 10};
  for (std::size_t place = 0; place < visits.size(); ++place) {
    const Vector begin(0.0, 5.0 * static_cast<double>(place), 0.0);
    for (std::size_t visit = 0; visit < visits[place]; ++visit) {
      scene.ribbons.push_back(ribbon_between(begin, begin + kX, kZ));
    }
  }
  const auto kept = thinned(scene.observations(), 50);
  EXPECT_EQ(20u, count_before(kept, 40));
  EXPECT_EQ(40u, count_before(kept, 65));
}

TEST(Thinned, EmptiesNoAreaWhereNothingIsSeenTwice) {
  Scene scene;
  constexpr std::size_t kStretches = 6, kRibbonsOfEach = 60;
  for (std::size_t i = 0; i < kStretches * kRibbonsOfEach; ++i) {
    const Vector begin(0.0, 0.5 * static_cast<double>(i), 0.0);
    scene.ribbons.push_back(ribbon_between(begin, begin + kX, kZ));
  }
  const auto kept = thinned(scene.observations(), kStretches * kRibbonsOfEach / 2);
  for (std::size_t end = kRibbonsOfEach; end <= kStretches * kRibbonsOfEach;
       end += kRibbonsOfEach) {
    const std::size_t left = count_before(kept, end) - count_before(kept, end - kRibbonsOfEach);
    EXPECT_GT(left, kRibbonsOfEach / 4) << "up to ribbon " << end;
  }
}

}  // namespace
}  // namespace ribbon_mapper
