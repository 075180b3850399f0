// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/rooms.hpp"

#include <gtest/gtest.h>

#include "modeler/surface/surface_config.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper {
namespace {

using namespace rectangles;
using Eigen::Vector3d;

/// Returns a floor of 6 x 8 m and a wall of 10 cm across it at y = 5, seen from smaller y, with a
/// doorway from x = 2 to 2.9.
std::vector<Plane> two_rooms() {
  const Plane wall = upright(0, 5, 6, 0, 2.6, 7);
  return {level(0, 0, 0, 6, 5), level(2, 5, 0, 0.9, 0.1), level(0, 5.1, 0, 6, 3),
          without(wall, {Vector3d(2, 4, -1), Vector3d(2.9, 6, 2.1)})};
}

Rooms rooms_in(const std::vector<Plane>& planes) {
  return rooms_of(planes, semantics_of(planes, {}), SurfaceConfig{}.stripe_gap_m);
}

TEST(Rooms, AreDividedAtADoorway) {
  const Rooms rooms = rooms_in(two_rooms());
  ASSERT_EQ(2u, rooms.rooms.size());
  EXPECT_NEAR(30.0, rooms.rooms[0].area_m2, 0.7);
  EXPECT_NEAR(18.0, rooms.rooms[1].area_m2, 0.7);
  EXPECT_NEAR(rooms.rooms[0].area_m2, area(rooms.rooms[0].outlines), 0.5);
  EXPECT_NEAR(2.5, rooms.rooms[0].centre.y(), 0.1);
  ASSERT_EQ(1u, rooms.passages.size());
  EXPECT_EQ((std::array<std::size_t, 2>{0, 1}), rooms.passages[0].rooms);
  EXPECT_EQ(7, rooms.passages[0].opening.plane);
}

TEST(Rooms, HaveOnePassageThoughBothSidesOfTheWallWereSeen) {
  std::vector<Plane> planes = two_rooms();
  Plane back = rectangle({6, 5.1, 0}, {-6, 0, 0}, {0, 0, 2.6}, 8);
  planes.push_back(without(back, {Vector3d(2, 4, -1), Vector3d(2.9, 6, 2.1)}));
  const Rooms rooms = rooms_in(planes);
  EXPECT_EQ(2u, rooms.rooms.size());
  EXPECT_EQ(1u, rooms.passages.size());
}

TEST(Rooms, WithoutAWallAreOne) {
  std::vector<Plane> planes = two_rooms();
  planes.pop_back();
  EXPECT_EQ(1u, rooms_in(planes).rooms.size());
  EXPECT_TRUE(rooms_in(planes).passages.empty());
}

TEST(Rooms, HaveNamesAndOutlinesAtTheHeightOfTheFloor) {
  EXPECT_EQ("A", room_name(0));
  EXPECT_EQ("Z", room_name(25));
  EXPECT_EQ("AA", room_name(26));
  EXPECT_EQ("ZZ", room_name(701));
  EXPECT_EQ("AAA", room_name(702));
  const Polygon square{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}}}};
  const std::vector<Outline> outlines = floor_outlines({8.5, {0.5, 0.5, -0.2}, {square}});
  ASSERT_EQ(1u, outlines.size());
  EXPECT_EQ(Vector3d(3, 3, -0.2), outlines[0].outer[2]);
  ASSERT_EQ(1u, outlines[0].holes.size());
  EXPECT_EQ(Vector3d(2, 2, -0.2), outlines[0].holes[0][2]);
}

TEST(Rooms, OfNothingAreNone) { EXPECT_TRUE(rooms_in({}).rooms.empty()); }

}  // namespace
}  // namespace ribbon_mapper
