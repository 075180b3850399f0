// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/floor_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/surface/outline.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper {
namespace {

using namespace rectangles;
using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHeight_m = 2.6;

/// Returns a face of a wall from a to b, seen from the right of that direction.
Plane face(const Vector2d& a, const Vector2d& b, std::int64_t id) {
  return rectangle({a.x(), a.y(), 0}, {b.x() - a.x(), b.y() - a.y(), 0}, {0, 0, kHeight_m}, id);
}

/// Returns planes turned about the vertical axis.
std::vector<Plane> turned(std::vector<Plane> planes, double angle_rad) {
  const Eigen::AngleAxisd turn(angle_rad, Vector3d::UnitZ());
  for (Plane& plane : planes) {
    for (Vector3d* v :
         {&plane.normal, &plane.origin, &plane.axis_u, &plane.axis_v, &plane.centroid}) {
      *v = turn * *v;
    }
  }
  return planes;
}

FloorPlan plan_of(std::vector<Plane> planes) {
  for (Plane& plane : planes) plane.outlines = outlines_of(plane, {});
  const Semantics semantics = semantics_of(planes, {});
  return floor_plan_of(planes, semantics,
                       rooms_of(planes, semantics, SurfaceConfig{}.stripe_gap_m));
}

/// Returns a wall of 4 x 0.1 m along x from the origin on, with both faces, and floor before it.
std::vector<Plane> wall() {
  return {level(0, -3, 0, 4, 3, 1), face({0, 0}, {4, 0}, 2), face({4, 0.1}, {0, 0.1}, 3)};
}

/// Returns a wall of 4 x 0.15 m between two rooms, with a door of 0.9 x 2.1 m.
std::vector<Plane> wall_with_door() {
  const AlignedBox3d door(Vector3d(1.5, -1, -1), Vector3d(2.4, 1, 2.1));
  return {level(0, -3, 0, 4, 3, 1), level(1.5, 0, 0, 0.9, 0.15, 1), level(0, 0.15, 0, 4, 3, 1),
          without(face({0, 0}, {4, 0}, 2), door), without(face({4, 0.15}, {0, 0.15}, 3), door)};
}

/// Returns a room of 5 x 4 m whose walls of 0.2 m were seen from inside and outside.
std::vector<Plane> room_with_both_faces() {
  return {level(0, 0, 0, 5, 4, 1),
          face({0, 4}, {5, 4}, 2),
          face({5, 0}, {0, 0}, 3),
          face({0, 0}, {0, 4}, 4),
          face({5, 4}, {5, 0}, 5),
          face({5.2, 4.2}, {-0.2, 4.2}, 6),
          face({-0.2, -0.2}, {5.2, -0.2}, 7),
          face({-0.2, 4.2}, {-0.2, -0.2}, 8),
          face({5.2, -0.2}, {5.2, 4.2}, 9)};
}

TEST(FloorPlan, HasTheThicknessOfAWallOfWhichBothFacesWereSeen) {
  const FloorPlan plan = plan_of(wall());
  ASSERT_EQ(1u, plan.walls.size());
  EXPECT_EQ((std::vector<std::int64_t>{2, 3}), plan.walls[0].planes);
  ASSERT_TRUE(plan.walls[0].thickness_m);
  EXPECT_NEAR(0.1, *plan.walls[0].thickness_m, 1e-9);
  EXPECT_NEAR(0.4, area(plan.walls[0].footprint), 1e-6);
  EXPECT_NEAR(0.4, area(plan.solid), 1e-6);
}

TEST(FloorPlan, HasALineWhereOneFaceWasSeen) {
  std::vector<Plane> planes = wall();
  planes.pop_back();
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.walls.size());
  EXPECT_FALSE(plan.walls[0].thickness_m);
  EXPECT_TRUE(plan.walls[0].footprint.empty());
  EXPECT_NEAR(4.0, (plan.walls[0].face[1] - plan.walls[0].face[0]).norm(), 1e-6);
  EXPECT_TRUE(plan.solid.empty());
}

TEST(FloorPlan, TakesNoRoomForAWall) {
  for (const double depth_m : {0.3, 0.6}) {  // faces that look at each other; two walls
    std::vector<Plane> planes{level(0, -3, 0, 4, 3, 1), face({0, 0}, {4, 0}, 2)};
    planes.push_back(depth_m < 0.5 ? face({4, -depth_m}, {0, -depth_m}, 3)
                                   : face({4, depth_m}, {0, depth_m}, 3));
    EXPECT_TRUE(plan_of(planes).solid.empty()) << depth_m;
    EXPECT_EQ(2u, plan_of(planes).walls.size()) << depth_m;
  }
}

TEST(FloorPlan, IsOpenInADoorway) {
  const FloorPlan plan = plan_of(wall_with_door());
  ASSERT_EQ(1u, plan.openings.size());
  const PlanOpening& door = plan.openings[0];
  EXPECT_TRUE(door.is_door());
  EXPECT_NEAR(0.9, (door.jambs[1] - door.jambs[0]).norm(), 0.051) << "within a cell";
  ASSERT_TRUE(door.depth_m);
  EXPECT_NEAR(0.15, *door.depth_m, 1e-6);
  EXPECT_NEAR(0.075, door.middle().y(), 1e-6);
  EXPECT_EQ((std::vector<std::size_t>{0, 1}), door.rooms);
  EXPECT_EQ(2u, plan.walls.size()) << "one on each side of the door";
  EXPECT_NEAR((4.0 - 0.9) * 0.15, area(plan.solid), 0.01);
  EXPECT_GT(distance(plan.solid, door.middle()), 0.4);
}

TEST(FloorPlan, OpensBothFacesThoughOneShowsTheDoor) {
  std::vector<Plane> planes = wall_with_door();
  planes.back() = face({4, 0.15}, {0, 0.15}, 3);  // where nobody has looked through the door
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.openings.size());
  EXPECT_GT(distance(plan.solid, plan.openings[0].middle()), 0.4);
}

TEST(FloorPlan, JambsAreAtTheReveals) {
  std::vector<Plane> planes = wall_with_door();
  planes.push_back(face({1.51, 0}, {1.51, 0.15}, 8));
  planes.push_back(face({2.41, 0.15}, {2.41, 0}, 9));
  for (std::size_t i = 5; i < 7; ++i) {  // as high as the door
    planes[i] = without(planes[i], {Vector3d(0, -1, 2.1), Vector3d(4, 1, 3)});
  }
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.openings.size());
  EXPECT_NEAR(0.9, (plan.openings[0].jambs[1] - plan.openings[0].jambs[0]).norm(), 1e-6);
  EXPECT_NEAR(1.96, plan.openings[0].middle().x(), 1e-6);
  EXPECT_EQ(2u, plan.walls.size()) << "reveals are no walls of their own";
}

TEST(FloorPlan, LeavesHangAtTheirJamb) {
  std::vector<Plane> planes = wall_with_door();
  for (const double back_m : {0.0, 0.05}) {  // both faces, the second one narrower
    planes.push_back(rectangle({1.5 + back_m, -0.85 + back_m, 0.0}, {0, 0.85 - 2.0 * back_m, 0},
                               {0, 0, 2.0}, back_m > 0.0 ? 9 : 8));
  }
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.openings.size());
  ASSERT_EQ(1u, plan.openings[0].leaves.size());
  const PlanLeaf& leaf = plan.openings[0].leaves[0];
  EXPECT_EQ(8, leaf.plane);
  EXPECT_NEAR(0.0, (leaf.hinge - Vector2d(1.5, 0.0)).norm(), 0.01);
  EXPECT_NEAR(0.0, (leaf.tip - Vector2d(1.5, -0.85)).norm(), 0.01);
}

TEST(FloorPlan, FillsCorners) {
  for (const double angle_rad : {0.0, M_PI / 4.0, 0.3}) {
    const FloorPlan plan = plan_of(turned(room_with_both_faces(), angle_rad));
    ASSERT_EQ(4u, plan.walls.size()) << angle_rad;
    double sum_m2 = 0.0;
    for (const PlanWall& wall : plan.walls) {
      ASSERT_TRUE(wall.thickness_m);
      EXPECT_NEAR(0.2, *wall.thickness_m, 1e-6) << angle_rad;
      sum_m2 += area(wall.footprint);
    }
    EXPECT_NEAR(5.4 * 4.4 - 5.0 * 4.0, area(plan.solid), 0.02) << angle_rad;
    EXPECT_NEAR(sum_m2, area(plan.solid), 0.02) << "walls do not overlap";
    ASSERT_EQ(1u, plan.solid.size()) << "one ring of walls";
    EXPECT_LE(plan.solid[0].outer.size(), 5u) << "corners without slivers; a ring begins somewhere";
  }
}

TEST(FloorPlan, FillsTheEndOfAWallAtAJunction) {
  std::vector<Plane> planes{level(0, -3, 0, 4, 3, 1), face({0, 0}, {4, 0}, 2),
                            face({4, 0.2}, {2.1, 0.2}, 3), face({2, 0.2}, {0, 0.2}, 4)};
  planes.push_back(face({2, 3}, {2, 0.2}, 5));  // the stem, 0.1 m thick
  planes.push_back(face({2.1, 0.2}, {2.1, 3}, 6));
  const FloorPlan plan = plan_of(planes);
  EXPECT_NEAR(4.0 * 0.2 + 2.8 * 0.1, area(plan.solid), 0.005);
  EXPECT_EQ(0.0, distance(plan.solid, {2.05, 0.1}));
  EXPECT_EQ(1u, plan.solid.size());
}

TEST(FloorPlan, GoesOnWhereFurnitureHidesAFace) {
  std::vector<Plane> planes = wall();
  planes[2] = without(planes[2], {Vector3d(1, -1, -1), Vector3d(3, 1, 3)});
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.walls.size());
  EXPECT_NEAR(0.4, area(plan.solid), 1e-6);
}

TEST(FloorPlan, IsOpenBelowABeam) {
  const AlignedBox3d gap(Vector3d(0.5, -1, -1), Vector3d(3.5, 1, 2.2));
  std::vector<Plane> planes{level(0, -3, 0, 4, 6, 1), without(face({0, 0}, {4, 0}, 2), gap),
                            without(face({4, 0.1}, {0, 0.1}, 3), gap)};
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.openings.size());
  EXPECT_NEAR(3.0, (plan.openings[0].jambs[1] - plan.openings[0].jambs[0]).norm(), 0.1);
  EXPECT_NEAR(0.1, area(plan.solid), 0.01);
}

TEST(FloorPlan, RoomsReachFromWallToWall) {
  std::vector<Plane> planes = room_with_both_faces();
  planes[0] = without(planes[0], {Vector3d(0, 0, -1), Vector3d(2, 2, 1)});  // below a bed
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.rooms.size());
  EXPECT_TRUE(plan.rooms[0].is_enclosed);
  EXPECT_NEAR(20.0, plan.rooms[0].area_m2, 0.05);
  EXPECT_NEAR(16.0, plan.rooms[0].free_floor_m2, 0.5);
  EXPECT_EQ(0.0, distance(plan.rooms[0].outline, plan.rooms[0].middle));
}

TEST(FloorPlan, WallsGoOnBehindFurniture) {
  for (const bool is_passage : {false, true}) {
    std::vector<Plane> planes = room_with_both_faces();
    planes.erase(planes.begin() + 5, planes.end());  // seen from inside
    planes[1] = without(planes[1], {Vector3d(1, 3, -1), Vector3d(2.5, 5, 3)});
    if (is_passage) planes.push_back(level(1, 4, 0, 1.5, 1, 1));
    if (!is_passage) planes[0] = without(planes[0], {Vector3d(1, 3.4, -1), Vector3d(2.5, 5, 1)});
    const FloorPlan plan = plan_of(planes);
    ASSERT_FALSE(plan.rooms.empty());
    EXPECT_EQ(!is_passage, plan.rooms[0].is_enclosed);
    EXPECT_EQ(is_passage, plan.hidden.empty());
    if (!is_passage) {
      EXPECT_NEAR(20.0, plan.rooms[0].area_m2, 0.05);
    }
  }
}

TEST(FloorPlan, RoomsWithoutAWallAreAsLargeAsTheirFloor) {
  std::vector<Plane> planes = room_with_both_faces();
  planes.erase(planes.begin() + 1);  // a wall of which the outer face was seen
  planes.erase(planes.begin() + 4);  // now not that one either
  const FloorPlan plan = plan_of(planes);
  ASSERT_EQ(1u, plan.rooms.size());
  EXPECT_FALSE(plan.rooms[0].is_enclosed);
  EXPECT_NEAR(20.0, plan.rooms[0].area_m2, 1.0);
}

TEST(FloorPlan, OfNothingIsEmpty) {
  for (const auto& planes : {std::vector<Plane>(), std::vector<Plane>{Plane()},
                             std::vector<Plane>{level(0, 0, 0, 0.5, 0.5)}}) {
    const FloorPlan plan = plan_of(planes);
    EXPECT_TRUE(plan.walls.empty() && plan.solid.empty() && plan.openings.empty());
    EXPECT_TRUE(plan.rooms.empty());
  }
}

}  // namespace
}  // namespace ribbon_mapper
