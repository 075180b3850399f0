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

const Vector x = Vector::UnitX(), y = Vector::UnitY(), z = Vector::UnitZ();

std::size_t count_before(const std::vector<std::uint32_t>& indices, std::size_t end) {
  return static_cast<std::size_t>(
      std::count_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < end; }));
}

TEST(Thinned, LeavesFewRibbonsAlone) {
  Scene scene;
  scene.add(patch({0, 0, 0}, x, y));
  EXPECT_EQ(26u, thinned(scene.observations(), 26).size());
  EXPECT_EQ(20u, thinned(scene.observations(), 20).size());
}

TEST(Thinned, TakesFromWhereMostSeeTheSame) {
  Scene scene;
  scene.add(patch({0, 0, 0}, x, y));  // seen once
  const std::size_t once = scene.ribbons.size();
  for (int visit = 0; visit < 20; ++visit) scene.add(patch({5, 0, 0}, x, y));
  const auto kept = thinned(scene.observations(), once * 5);
  EXPECT_EQ(once * 5, kept.size());
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(once, count_before(kept, once));
}

TEST(Thinned, TheTwoSidesOfAWallAreTwoPlaces) {
  Scene scene;
  scene.add(patch({2.0, 0, 0}, y, z));
  const std::size_t once = scene.ribbons.size();
  for (int visit = 0; visit < 20; ++visit) scene.add(patch({2.02, 0, 0}, z, y));
  EXPECT_EQ(once, count_before(thinned(scene.observations(), once * 5), once));
}

TEST(Thinned, ALongRibbonThatSeesNewThingsStays) {
  Scene scene;
  scene.ribbons.push_back(ribbon_between({0, 0.5, 0}, {4, 0.5, 0}, z));
  for (int visit = 0; visit < 20; ++visit) scene.add(patch({0, 0, 0}, x, y));
  const auto kept = thinned(scene.observations(), 60);
  EXPECT_EQ(0u, kept.front());
}

TEST(Thinned, WhereNothingIsSeenTwiceNoPlaceGoesEmpty) {
  Scene scene;
  constexpr std::size_t places = 6, of_each = 60;
  for (std::size_t i = 0; i < places * of_each; ++i) {
    const Vector begin(0.0, 0.5 * static_cast<double>(i), 0.0);
    scene.ribbons.push_back(ribbon_between(begin, begin + x, z));
  }
  const auto kept = thinned(scene.observations(), places * of_each / 2);
  for (std::size_t end = of_each; end <= places * of_each; end += of_each) {
    const std::size_t left = count_before(kept, end) - count_before(kept, end - of_each);
    EXPECT_GT(left, of_each / 4) << "up to ribbon " << end;
  }
}

}  // namespace
}  // namespace ribbon_mapper
