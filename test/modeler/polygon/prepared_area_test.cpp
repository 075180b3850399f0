// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/polygon/prepared_area.hpp"

#include <gtest/gtest.h>

#include <random>

namespace ribbon_mapper {
namespace {

TEST(PreparedArea, HoldsWhatLiesAtNoDistance) {
  const Ring square{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}};
  const Ring hole{{1.0, 1.0}, {1.0, 3.0}, {3.0, 3.0}, {3.0, 1.0}};
  const Ring triangle{{5.0, 0.0}, {8.0, 0.0}, {5.0, 4.0}};
  const Polygons polygons{{square, {hole}}, {triangle, {}}};
  const PreparedArea area(polygons);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1.0, 9.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d point(place(random), place(random));
    EXPECT_EQ(distance(polygons, point) == 0.0, area.holds(point)) << point.transpose();
  }
  EXPECT_TRUE(area.holds({4.0, 2.0})) << "the boundary";
}

TEST(PreparedArea, WithoutPolygonsHoldsNothing) {
  EXPECT_FALSE(PreparedArea({}).holds({0.0, 0.0}));
}

TEST(PreparedArea, RefusesWhatIsNoArea) {
  EXPECT_THROW(PreparedArea({{{{0.0, 0.0}, {1.0, 0.0}}, {}}}), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper
