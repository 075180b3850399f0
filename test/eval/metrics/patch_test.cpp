// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/patch.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace ribbon_mapper::eval {
namespace {

/// Returns a table top at z = 0.75 m with three cells in an L shape.
Plane table() {
  Plane plane;
  plane.normal = {0.0, 0.0, 1.0};
  plane.d_m = -0.75;
  plane.area_m2 = 0.0075;
  plane.origin = {1.0, 2.0, 0.75};
  plane.cells = {{0, 0, 4, 0.0F, 0.0F}, {1, 0, 1, 0.0F, 0.0F}, {0, -1, 2, 0.0F, 0.0F}};
  return plane;
}

TEST(Patch, HasTheCentresOfTheCells) {
  const Patch patch = patch_of(table());
  ASSERT_EQ(patch.cells.size(), 3U);
  EXPECT_TRUE(patch.cells[0].isApprox(Eigen::Vector3d(1.025, 2.025, 0.75)));
  EXPECT_TRUE(patch.cells[1].isApprox(Eigen::Vector3d(1.075, 2.025, 0.75)));
  EXPECT_TRUE(patch.cells[2].isApprox(Eigen::Vector3d(1.025, 1.975, 0.75)));
  EXPECT_DOUBLE_EQ(patch.d_m, -0.75);
  EXPECT_DOUBLE_EQ(patch.area_m2, 0.0075);
}

TEST(Patch, CentroidIsTheMeanOfTheCells) {
  EXPECT_TRUE(centroid_of(patch_of(table()))
                  .isApprox(Eigen::Vector3d(1.0 + 0.125 / 3.0, 2.0 + 0.025 / 3.0, 0.75)));
}

TEST(Patch, WithoutCellsTheCentroidLiesOnThePlane) {
  Patch patch;
  patch.d_m = -0.75;
  EXPECT_TRUE(centroid_of(patch).isApprox(Eigen::Vector3d(0.0, 0.0, 0.75)));
}

TEST(Patch, AsAPlaneItKeepsItsCellsToHalfACell) {
  const Patch patch = patch_of(table());
  const Plane plane = plane_of(patch, 5);
  EXPECT_EQ(plane.id, 5);
  EXPECT_TRUE(plane.axis_u.cross(plane.axis_v).isApprox(plane.normal));
  ASSERT_EQ(plane.cells.size(), 3U);
  for (const Eigen::Vector3d& cell : patch.cells) {
    const bool is_near =
        std::any_of(plane.cells.begin(), plane.cells.end(), [&](const PlaneCell& c) {
          const Eigen::Vector3d apart = cell_centre(plane, c) - cell;
          return apart.norm() < 0.0354;  // half of a cell's diagonal
        });
    EXPECT_TRUE(is_near) << cell.transpose();
  }
}

}  // namespace
}  // namespace ribbon_mapper::eval
