// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/polygon/polygon_operations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ribbon_mapper {
namespace {

Ring box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

const Polygons kSquare{{box(0, 0, 4, 4), {}}};

TEST(Polygons, OfRingsAreEvenOdd) {
  const Polygons polygons = polygons_of({box(0, 0, 10, 10), box(2, 2, 6, 6), box(3, 3, 1, 1)});
  ASSERT_EQ(2u, polygons.size());
  EXPECT_DOUBLE_EQ(100 - 36 + 1, area(polygons));
  for (const Polygon& polygon : polygons) {
    EXPECT_GT(signed_area(polygon.outer), 0.0);
    for (const Ring& hole : polygon.holes) EXPECT_LT(signed_area(hole), 0.0);
  }
}

TEST(Polygons, OfNothingAreNone) {
  EXPECT_TRUE(polygons_of({}).empty());
  EXPECT_TRUE(simplified({}, 1.0).empty());
  EXPECT_TRUE(intersection({}, kSquare).empty());
}

TEST(Polygons, OverlaysHaveTheAreasOfSets) {
  const Polygons other{{box(2, 1, 4, 2), {}}};
  EXPECT_DOUBLE_EQ(4.0, area(intersection(kSquare, other)));
  EXPECT_DOUBLE_EQ(16.0 + 8.0 - 4.0, area(united(kSquare, other)));
  EXPECT_DOUBLE_EQ(16.0 - 4.0, area(difference(kSquare, other)));
}

TEST(Polygons, ThatTouchInALineHaveNoAreaInCommon) {
  EXPECT_TRUE(intersection(kSquare, {{box(4, 0, 1, 4), {}}}).empty());
}

TEST(Polygons, SimplifiedKeepHolesAndTolerance) {
  Polygon saw{{{0, 0}, {10, 0}, {10, 5}}, {box(2, 1, 1, 1)}};
  for (int x = 9; x > 0; --x) saw.outer.emplace_back(x, x % 2 == 0 ? 5.0 : 5.1);
  saw.outer.emplace_back(0, 5);
  const Polygons few = simplified({saw}, 0.2);
  ASSERT_EQ(1u, few.size());
  EXPECT_EQ(4u, few[0].outer.size());
  ASSERT_EQ(1u, few[0].holes.size());
  EXPECT_NEAR(area(saw), area(few), 10 * 0.2);
}

TEST(Polygons, GrowAndShrinkWithCorners) {
  EXPECT_NEAR(36.0, area(grown(kSquare, 1.0)), 1e-9);
  EXPECT_NEAR(4.0, area(grown(kSquare, -1.0)), 1e-9);
  EXPECT_TRUE(grown(kSquare, -3.0).empty());
}

TEST(Polygons, HaveADistanceFromPoints) {
  const Polygons ring{{box(0, 0, 4, 4), {box(1, 1, 2, 2)}}};
  EXPECT_DOUBLE_EQ(0.0, distance(ring, {0.5, 2.0}));
  EXPECT_DOUBLE_EQ(0.75, distance(ring, {2.0, 1.75}));  // in the hole
  EXPECT_DOUBLE_EQ(5.0, distance(ring, {7.0, 8.0}));
  EXPECT_TRUE(std::isinf(distance({}, {0.0, 0.0})));
}

TEST(Polygons, HaveAnInmostPointThatIsInside) {
  const Polygons around{{box(0, 0, 10, 10), {box(1, 1, 6, 8)}}};  // its mean is in the hole
  const Eigen::Vector2d inmost = inmost_point(around, 0.01);
  EXPECT_NEAR(8.5, inmost.x(), 0.02);
  EXPECT_EQ(0.0, distance(around, inmost));
}

TEST(Polygons, AreValidIfTheirRingsDoNotIntersect) {
  EXPECT_TRUE(is_valid(kSquare));
  EXPECT_FALSE(is_valid({{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}}));
  EXPECT_FALSE(is_valid({{box(0, 0, 4, 4), {box(3, 3, 2, 2)}}}));
  EXPECT_FALSE(is_valid({{{{0, 0}, {1, 1}}, {}}}));
  EXPECT_FALSE(is_valid({{box(0, 0, 4, 4), {}}, {box(3, 0, 4, 4), {}}})) << "they overlap";
}

/// The outline of a plane that was projected on another one, with a fold that rounding has opened.
TEST(Polygons, WhoseRingsTouchThemselvesByRoundingAreMended) {
  const Polygons folded{{{{5.300513, 2.502775},
                          {5.300523, 2.502775},
                          {4.800523, 2.502872},
                          {4.750542, 2.502882},
                          {4.950542, 2.502843},
                          {4.950523, 2.353607},
                          {5.802524, 2.353658},
                          {5.802375, 2.502677}},
                         {}}};
  ASSERT_FALSE(is_valid(folded));
  const Polygons around{{box(4, 2, 2, 1), {}}};
  EXPECT_NEAR(0.127, area(intersection(folded, around)), 0.001);
  EXPECT_NEAR(2.0, area(united(folded, around)), 0.001);
}

TEST(Polygons, ThatAreNoneSayWhy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Polygons bad{{{{0, 0}, {nan, 0}, {0, 1}}, {}}};
  EXPECT_THROW(united(bad, kSquare), std::invalid_argument);
  EXPECT_THROW(polygons_of({{}}), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper
