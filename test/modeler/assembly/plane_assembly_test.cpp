// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/plane_assembly.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

const Vector x = Vector::UnitX(), y = Vector::UnitY(), z = Vector::UnitZ();
const AssociationConfig gates;
const SurfaceConfig surface_config;
const AssemblyConfig config;

std::vector<Plane> filtered(const Scene& scene, const AssociationGates& within = gates.corrected) {
  return assembled_planes(scene.map(within).merged_hypotheses(), within, scene.observations(),
                          surface_config, config);
}
std::vector<Plane> confirmed(const Scene& scene) {
  return assembled_as_built(scene.map().hypotheses(), scene.observations(), surface_config, config);
}

Scene floor_patches(double gap_m) {
  Scene scene;
  scene.add(patch({1.013, 0.017, 0.0}, x, y));  // no point lies on the border of a cell
  scene.add(patch({2.013 + gap_m, 0.017, 0.0}, x, y));
  return scene;
}

TEST(FilteredPlanes, GapsOfUpToAMetreAreBridged) {
  EXPECT_EQ(1u, filtered(floor_patches(0.2)).size());
  EXPECT_EQ(1u, filtered(floor_patches(0.9)).size());
  const auto apart = filtered(floor_patches(1.15));
  ASSERT_EQ(2u, apart.size());
  EXPECT_NE(apart[0].id, apart[1].id);
  EXPECT_NEAR(2.0, (apart[0].centroid - apart[1].centroid).norm(), 0.2);
}

TEST(FilteredPlanes, WhatPassedForOneTiltedPlaneIsParted) {
  for (const double step_m : {0.0, 0.1}) {
    Scene scene;
    scene.add(patch({1.013, 0.017, 0.0}, x, y));
    scene.add(patch({2.513, 0.017, step_m}, x, y));
    const auto planes = assembled_planes({scene.whole()}, gates.corrected, scene.observations(),
                                         surface_config, config);
    ASSERT_EQ(step_m == 0.0 ? 1u : 2u, planes.size());
    for (const Plane& plane : planes) EXPECT_NEAR(1.0, plane.normal.z(), 1e-6);
  }
}

TEST(FilteredPlanes, TheAreaIsThatOfTheCellsHoweverOftenSeen) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, 2.0 * x, y));
  const double once_m2 = filtered(scene).at(0).area_m2;
  for (int i = 0; i < 9; ++i) scene.add(patch({1.0, 0.0, 0.0}, 2.0 * x, y));
  const Plane plane = filtered(scene).at(0);
  EXPECT_DOUBLE_EQ(once_m2, plane.area_m2);
  EXPECT_NEAR(2.0, plane.area_m2, 0.2);  // cells on the rim are seen in part
  double sum_m2 = 0.0;
  for (const Ribbon& ribbon : scene.ribbons) sum_m2 += ribbon.area_m2;
  EXPECT_GT(sum_m2, 3.0 * plane.area_m2);
}

TEST(FilteredPlanes, SmallOnesAreDropped) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, 0.6 * x, 0.6 * y));  // 0.36 m2
  EXPECT_EQ(0u, filtered(scene).size());
  EXPECT_EQ(1u, confirmed(scene).size());
  scene.add(patch({1.6, 0.0, 0.0}, 0.4 * x, 0.6 * y));  // 0.6 m2
  EXPECT_EQ(1u, filtered(scene).size());
}

TEST(ConfirmedPlanes, NeedRibbonsEnough) {
  Scene scene;
  for (int i = 0; i < 9; ++i) {
    scene.ribbons.push_back(ribbon_between({1.0, 0.05 * i, 0.0}, {3.0, 0.05 * i, 0.0}, z));
  }
  EXPECT_EQ(0u, confirmed(scene).size());
  scene.ribbons.push_back(ribbon_between({1.0, 0.5, 0.0}, {3.0, 0.5, 0.0}, z));
  EXPECT_EQ(1u, confirmed(scene).size());
}

/// The front of a column or, without a radius, of a board, 0.34 m wide and 2 m high, at x = 2.
Scene upright(std::optional<double> radius_m) {
  Scene scene;
  for (int i = 0; i <= 50; ++i) {
    std::vector<Vector> points;
    for (double side_m = 0.17; side_m > -0.175; side_m -= 0.01) {
      const double back_m =
          radius_m ? *radius_m - std::sqrt(*radius_m * *radius_m - side_m * side_m) : 0.0;
      points.emplace_back(2.0 + back_m, side_m, 0.04 * i);
    }
    scene.ribbons.push_back(ribbon_of(points, -x));
  }
  return scene;
}

TEST(FilteredPlanes, TheFacetOfAColumnIsNoPlane) {
  EXPECT_EQ(1u, filtered(upright({}), gates.slam).size());
  EXPECT_EQ(0u, filtered(upright(0.2), gates.slam).size());
  EXPECT_EQ(1u, filtered(upright(20.0), gates.slam).size());
}

TEST(FilteredPlanes, AreInTheMapFrameWhereverThatIs) {
  Scene scene = floor_patches(0.5);
  const Plane here = filtered(scene).at(0);
  const Pose T = Eigen::Translation3d(5.0, -7.0, 1.0) *
                 Eigen::AngleAxisd(1.0, Vector(0.1, 0.9, 0.4).normalized());
  scene.poses[0].T_map_base = T;
  const Plane there = filtered(scene).at(0);
  EXPECT_LT((T.linear() * here.normal - there.normal).norm(), 1e-9);
  EXPECT_LT((T * here.centroid - there.centroid).norm(), 1e-9);
  EXPECT_NEAR(0.0, there.normal.dot(there.centroid) + there.d_m, 1e-9);
  EXPECT_EQ(here.cells.size(), there.cells.size());
  for (const Vector& corner : there.outline) {
    EXPECT_NEAR(0.0, there.normal.dot(corner) + there.d_m, 1e-9);
  }
}

/// A floor of 1 x 0.4 m (too small by itself) beside which single points were seen at y up to
/// 0.55 m, at this height, by a sensor at this height.
std::size_t floors_with_unassigned(double height_m, double sensor_m, double y_m = 0.45) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, x, 0.4 * y));
  std::vector<PackedPoint> points;
  UnassignedPoints unassigned;
  unassigned.sensor = {0.0F, 0.0F, static_cast<float>(sensor_m)};
  for (int i = 0; i < 100; ++i) {
    for (double side = y_m; side < y_m + 0.1; side += 0.05) {
      const Vector point(1.005 + 0.01 * i, side + 0.01, height_m);
      const Eigen::Vector3f steps = (point.cast<float>() - unassigned.sensor) / unassigned.step_m;
      points.push_back({{static_cast<std::int16_t>(steps.x()), static_cast<std::int16_t>(steps.y()),
                         static_cast<std::int16_t>(steps.z())},
                        1});
    }
  }
  unassigned.first = points.data(), unassigned.size = static_cast<std::uint32_t>(points.size());
  scene.unassigned.push_back(unassigned);
  return filtered(scene).size();
}

TEST(FilteredPlanes, PointsOfNoRibbonSayHowFarAPlaneWasSeen) {
  EXPECT_EQ(1u, floors_with_unassigned(0.01, 1.2));
  EXPECT_EQ(0u, floors_with_unassigned(0.06, 1.2));        // not on it
  EXPECT_EQ(0u, floors_with_unassigned(0.01, -1.2));       // seen from below
  EXPECT_EQ(0u, floors_with_unassigned(0.01, 1.2, 0.90));  // not beside it
}

}  // namespace
}  // namespace ribbon_mapper
