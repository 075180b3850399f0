// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/corner_lines.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;
constexpr double kReach_m = 0.1;

/// Returns a rectangle from a corner along two axes.
Plane rectangle(const Vector3d& corner, const Vector3d& along, const Vector3d& up) {
  Plane plane;
  plane.origin = corner;
  plane.axis_u = along.normalized(), plane.axis_v = up.normalized();
  plane.normal = plane.axis_u.cross(plane.axis_v);
  plane.d_m = -plane.normal.dot(corner);
  plane.outlines = {{{corner, corner + along, corner + along + up, corner + up}, {}}};
  return plane;
}

/// Returns a floor of 4 m x 3 m at height 0, and a wall at x = 0 that looks along +x.
std::vector<Plane> floor_and_wall(double floor_begin_m, double wall_begin_m) {
  return {rectangle({floor_begin_m, 0, 0}, {4, 0, 0}, {0, 3, 0}),
          rectangle({0, 0, wall_begin_m}, {0, 3, 0}, {0, 0, 2.5})};
}

double distance_m(const Plane& plane, const Vector3d& point) {
  return std::abs(plane.normal.dot(point) + plane.d_m);
}

TEST(CornerLines, AreSharedByPlanesThatEndNearThem) {
  for (const double floor_m : {-0.05, 0.05}) {
    for (const double wall_m : {-0.05, 0.05}) {
      std::vector<Plane> planes = floor_and_wall(floor_m, wall_m);
      join_at_corner_lines(planes, kReach_m);
      const auto& floor = planes[0].outlines.at(0).outer;
      const auto& wall = planes[1].outlines.at(0).outer;
      for (const Vector3d& corner : {floor.at(0), floor.at(3), wall.at(0), wall.at(1)}) {
        EXPECT_NEAR(corner.x(), 0.0, 1e-12);
        EXPECT_NEAR(corner.z(), 0.0, 1e-12);
      }
      EXPECT_EQ(floor.at(1), Vector3d(4.0 + floor_m, 0.0, 0.0)) << "far from the line";
    }
  }
}

TEST(CornerLines, OfThreePlanesMeetInOnePoint) {
  std::vector<Plane> planes = floor_and_wall(0.04, 0.06);
  planes.push_back(rectangle({0.07, 3, 0.03}, {0, 0, 2.5}, {4, 0, 0}));  // looks along -y
  for (Vector3d& corner : planes[0].outlines[0].outer) corner.y() *= 0.98;
  for (Vector3d& corner : planes[1].outlines[0].outer) corner.y() *= 0.98;
  join_at_corner_lines(planes, kReach_m);
  for (const Plane& plane : planes) {
    const auto& ring = plane.outlines.at(0).outer;
    const bool has_corner = std::any_of(ring.begin(), ring.end(), [](const Vector3d& corner) {
      return (corner - Vector3d(0, 3, 0)).norm() < 1e-12;
    });
    EXPECT_TRUE(has_corner) << plane.normal.transpose();
  }
}

TEST(CornerLines, AreLeftAloneFarFromTheirPlanes) {
  for (const auto& [floor_m, wall_m] : {std::pair(0.12, 0.0), std::pair(0.0, 0.12)}) {
    std::vector<Plane> planes = floor_and_wall(floor_m, wall_m);
    const auto floor = planes[0].outlines[0].outer, wall = planes[1].outlines[0].outer;
    join_at_corner_lines(planes, kReach_m);
    EXPECT_EQ(planes[floor_m > 0.0 ? 0 : 1].outlines[0].outer, floor_m > 0.0 ? floor : wall);
  }
}

TEST(CornerLines, AreNoneBetweenPlanesThatAreAlmostParallel) {
  std::vector<Plane> planes = floor_and_wall(0.05, 0.05);
  planes[1] = rectangle({0, 0, 0}, {0, 3, 0}, {-2, 0, 0.5});  // a ramp of 14 degrees
  const auto floor = planes[0].outlines[0].outer;
  join_at_corner_lines(planes, kReach_m);
  EXPECT_EQ(planes[0].outlines[0].outer, floor);
}

TEST(CornerLines, LeaveAnOutlineThatWouldOverlapItself) {
  std::vector<Plane> planes = floor_and_wall(0.0, 0.0);
  // A tongue along the wall, all of which would fall on the line.
  planes[0].outlines[0].outer = {{0.09, 0, 0}, {0.09, 1, 0}, {0.02, 1, 0}, {0.02, 0, 0}};
  const auto before = planes[0].outlines[0].outer;
  join_at_corner_lines(planes, kReach_m);
  EXPECT_EQ(planes[0].outlines[0].outer, before);
}

/// Two corners near the line lie behind each other: on the line, the way would go back on itself.
TEST(CornerLines, AreNotGoneForAndBack) {
  std::vector<Plane> planes = floor_and_wall(0.0, 0.05);
  planes[0].outlines[0].outer = {{0.05, 0, 0}, {4, 0, 0},    {4, 3, 0},     {0.05, 3, 0},
                                 {0.06, 1, 0}, {0.03, 2, 0}, {0.02, 0.5, 0}};
  join_at_corner_lines(planes, kReach_m);
  const auto& ring = planes[0].outlines.at(0).outer;
  ASSERT_EQ(ring.size(), 6U);
  EXPECT_NEAR((ring.at(3) - Vector3d(0, 3, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((ring.at(4) - Vector3d(0, 2, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((ring.at(5) - Vector3d(0, 0.5, 0)).norm(), 0.0, 1e-12);
}

TEST(CornerLines, KeepCornersOnTheirPlanes) {
  std::vector<Plane> planes = floor_and_wall(0.05, -0.05);
  planes.push_back(rectangle({0, 3, 0}, {0, 0, 2.5}, {4, 0.4, 0}));
  join_at_corner_lines(planes, kReach_m);
  for (const Plane& plane : planes) {
    for (const Vector3d& corner : plane.outlines.at(0).outer) {
      EXPECT_LT(distance_m(plane, corner), 1e-12);
    }
  }
}

TEST(CornerLines, OfNoPlanesAreNone) {
  std::vector<Plane> none;
  join_at_corner_lines(none, kReach_m);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace ribbon_mapper
