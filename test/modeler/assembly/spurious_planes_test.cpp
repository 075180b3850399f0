// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/spurious_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "modeler/surface/footprint.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

/// Returns a plane through `centre`, rotated about y: 0 degrees is level, 90 degrees is a wall seen
/// from -x.
Plane turned_plane(const Vector& centre, double angle_deg, int columns, int rows) {
  Plane plane = level_plane(0.0, rectangle(columns, rows, -columns / 2, -rows / 2));
  const Eigen::AngleAxisd turn(-angle_deg * M_PI / 180.0, Vector::UnitY());
  plane.axis_u = turn * Vector::UnitX();
  plane.normal = turn * Vector::UnitZ();
  plane.origin = plane.centroid = centre;
  plane.d_m = -plane.normal.dot(centre);
  return plane;
}

const Plane kFloor = turned_plane({1.0, 0.0, 0.0}, 0.0, 40, 60);
const Plane kWall = turned_plane({2.0, 0.0, 1.0}, 90.0, 40, 60);

/// Returns a plane across the corner of floor and wall. Its points, as measured, lie `height_m`
/// above it.
Plane across_the_corner(double distance_m, double height_m) {
  const Vector centre = Vector(2.0, 0.0, 0.0) + distance_m * Vector(-M_SQRT1_2, 0.0, M_SQRT1_2);
  Plane plane = turned_plane(centre, 45.0, 4, 40);
  plane.id = 7;
  for (PlaneCell& cell : plane.cells) cell.mean_m = static_cast<float>(height_m);
  return plane;
}

/// Returns true if a plane with the id 7 is not spurious beside floor and wall.
bool is_kept(const Plane& plane) {
  for (const Plane& kept :
       without_spurious_planes({plane, kFloor, kWall}, AssociationConfig{}.corrected,
                               SurfaceConfig{}.bridged_gap_m, {})) {
    if (kept.id == 7) return true;
  }
  return false;
}

TEST(WithoutSpuriousPlanes, RemovesAPlaneWhosePointsLieOnLargerOnes) {
  ASSERT_EQ(2u, without_spurious_planes({kFloor, kWall}, AssociationConfig{}.corrected,
                                        SurfaceConfig{}.bridged_gap_m, {})
                    .size());
  EXPECT_FALSE(is_kept(across_the_corner(0.03, 0.0)));
}

TEST(WithoutSpuriousPlanes, KeepsARealChamfer) {
  EXPECT_TRUE(is_kept(across_the_corner(0.3, 0.0)));
}

TEST(WithoutSpuriousPlanes, UsesThePointsAsMeasured) {
  EXPECT_TRUE(is_kept(across_the_corner(0.03, 0.3)));
  EXPECT_FALSE(is_kept(across_the_corner(0.33, -0.3)));
}

TEST(WithoutSpuriousPlanes, KeepsTheBackOfAThinWall) {
  Plane back = turned_plane({2.02, 0.0, 1.0}, -90.0, 30, 30);
  back.id = 7;
  EXPECT_TRUE(is_kept(back));
  Plane front = turned_plane({2.02, 0.0, 1.0}, 90.0, 30, 30);
  front.id = 7;
  EXPECT_FALSE(is_kept(front));
}

TEST(WithoutSpuriousPlanes, KeepsTheLeafOfADoorAjar) {
  for (const double angle_deg : {1.0, 3.0, 5.0}) {
    const double half_m = 0.45, angle = angle_deg * M_PI / 180.0;
    Plane leaf =
        turned_plane({2.0 + half_m * std::sin(angle), 0.0, half_m}, 90.0 - angle_deg, 18, 36);
    leaf.id = 7;
    EXPECT_EQ(angle_deg > 2.0, is_kept(leaf)) << angle_deg;
  }
}

TEST(Footprint, HoldsPointsOnThePlaneNearItsCells) {
  const Footprint footprint(kFloor, 0.15);  // x from 0 to 2, y from -1.5 to 1.5
  EXPECT_TRUE(footprint.holds({1.0, 0.0, 0.03}, 0.04));
  EXPECT_FALSE(footprint.holds({1.0, 0.0, 0.05}, 0.04));
  EXPECT_FALSE(footprint.holds({1.0, 0.0, -0.05}, 0.04));
  EXPECT_TRUE(footprint.holds({2.1, 0.0, 0.0}, 0.04));
  EXPECT_FALSE(footprint.holds({2.4, 0.0, 0.0}, 0.04));
  EXPECT_TRUE(footprint.holds({1.0, -1.6, 0.0}, 0.04));
  EXPECT_FALSE(footprint.holds({1.0, -1.9, 0.0}, 0.04));
}

}  // namespace
}  // namespace ribbon_mapper
