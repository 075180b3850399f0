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

const Vector kX = Vector::UnitX(), kY = Vector::UnitY(), kZ = Vector::UnitZ();
const AssociationConfig kAssociation;
const SurfaceConfig kSurfaceConfig;
const AssemblyConfig kAssemblyConfig;

/// Returns the planes of the model of a scene.
std::vector<Plane> planes_of(const Scene& scene,
                             const AssociationGates& within = kAssociation.corrected) {
  return assembled_planes(scene.map(within).merged_hypotheses(), within, scene.observations(),
                          kSurfaceConfig, kAssemblyConfig)
      .planes;
}

/// Returns the planes as built on the way.
std::vector<Plane> planes_as_built_of(const Scene& scene) {
  return assembled_as_built(scene.map().hypotheses(), AssociationConfig{}.corrected,
                            scene.observations(), kSurfaceConfig, kAssemblyConfig);
}

/// Returns two patches of a floor with a gap between them.
Scene floor_patches(double gap_m) {
  Scene scene;
  scene.add(patch({1.013, 0.017, 0.0}, kX, kY));  // no point lies on the border of a cell
  scene.add(patch({2.013 + gap_m, 0.017, 0.0}, kX, kY));
  return scene;
}

TEST(AssembledPlanes, BridgeGapsOfUpToAMetre) {
  EXPECT_EQ(1u, planes_of(floor_patches(0.2)).size());
  EXPECT_EQ(1u, planes_of(floor_patches(0.9)).size());
  const auto apart = planes_of(floor_patches(1.15));
  ASSERT_EQ(2u, apart.size());
  EXPECT_NE(apart[0].id, apart[1].id);
  EXPECT_NEAR(2.0, (apart[0].centroid - apart[1].centroid).norm(), 0.2);
}

TEST(AssembledPlanes, AreSplitWhereTwoLevelsWereTakenForATiltedPlane) {
  for (const double step_m : {0.0, 0.1}) {
    Scene scene;
    scene.add(patch({1.013, 0.017, 0.0}, kX, kY));
    scene.add(patch({2.513, 0.017, step_m}, kX, kY));
    const auto planes = assembled_planes({scene.whole()}, kAssociation.corrected,
                                         scene.observations(), kSurfaceConfig, kAssemblyConfig)
                            .planes;
    ASSERT_EQ(step_m == 0.0 ? 1u : 2u, planes.size());
    for (const Plane& plane : planes) EXPECT_NEAR(1.0, plane.normal.z(), 1e-6);
  }
}

TEST(AssembledPlanes, HaveTheAreaOfTheirCellsHoweverOftenSeen) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, 2.0 * kX, kY));
  const double once_m2 = planes_of(scene).at(0).area_m2;
  for (int i = 0; i < 9; ++i) scene.add(patch({1.0, 0.0, 0.0}, 2.0 * kX, kY));
  const Plane plane = planes_of(scene).at(0);
  EXPECT_DOUBLE_EQ(once_m2, plane.area_m2);
  EXPECT_NEAR(2.0, plane.area_m2, 0.2);  // cells on the rim are covered in part
  double sum_m2 = 0.0;
  for (const Ribbon& ribbon : scene.ribbons) sum_m2 += ribbon.area_m2;
  EXPECT_GT(sum_m2, 3.0 * plane.area_m2);
}

TEST(AssembledPlanes, ExcludeSmallOnes) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, 0.6 * kX, 0.6 * kY));  // 0.36 m2
  EXPECT_EQ(0u, planes_of(scene).size());
  EXPECT_EQ(1u, planes_as_built_of(scene).size());
  scene.add(patch({1.6, 0.0, 0.0}, 0.4 * kX, 0.6 * kY));  // 0.6 m2
  EXPECT_EQ(1u, planes_of(scene).size());
}

TEST(AssembledAsBuilt, RequiresEnoughRibbons) {
  Scene scene;
  for (int i = 0; i < 9; ++i) {
    scene.ribbons.push_back(ribbon_between({1.0, 0.05 * i, 0.0}, {3.0, 0.05 * i, 0.0}, kZ));
  }
  EXPECT_EQ(0u, planes_as_built_of(scene).size());
  scene.ribbons.push_back(ribbon_between({1.0, 0.5, 0.0}, {3.0, 0.5, 0.0}, kZ));
  EXPECT_EQ(1u, planes_as_built_of(scene).size());
}

/// Returns the front of a column or, without a radius, of a board. It is 0.34 m wide and 2 m high,
/// at x = 2.
Scene upright(std::optional<double> radius_m) {
  Scene scene;
  for (int i = 0; i <= 50; ++i) {
    std::vector<Vector> points;
    for (double side_m = 0.17; side_m > -0.175; side_m -= 0.01) {
      const double back_m =
          radius_m ? *radius_m - std::sqrt(*radius_m * *radius_m - side_m * side_m) : 0.0;
      points.emplace_back(2.0 + back_m, side_m, 0.04 * i);
    }
    scene.ribbons.push_back(ribbon_of(points, -kX));
  }
  return scene;
}

TEST(AssembledPlanes, ExcludeFacetsOfColumns) {
  EXPECT_EQ(1u, planes_of(upright({}), kAssociation.slam).size());
  EXPECT_EQ(0u, planes_of(upright(0.2), kAssociation.slam).size());
  EXPECT_EQ(1u, planes_of(upright(20.0), kAssociation.slam).size());
}

TEST(AssembledPlanes, AreInTheMapFrame) {
  Scene scene = floor_patches(0.5);
  const Plane here = planes_of(scene).at(0);
  const Pose T = Eigen::Translation3d(5.0, -7.0, 1.0) *
                 Eigen::AngleAxisd(1.0, Vector(0.1, 0.9, 0.4).normalized());
  scene.poses[0].T_map_base = T;
  const Plane there = planes_of(scene).at(0);
  EXPECT_LT((T.linear() * here.normal - there.normal).norm(), 1e-9);
  EXPECT_LT((T * here.centroid - there.centroid).norm(), 1e-9);
  EXPECT_NEAR(0.0, there.normal.dot(there.centroid) + there.d_m, 1e-9);
  EXPECT_EQ(here.cells.size(), there.cells.size());
  for (const Vector& corner : there.outlines.at(0).outer) {
    EXPECT_NEAR(0.0, there.normal.dot(corner) + there.d_m, 1e-9);
  }
}

/// Returns the number of planes of a floor of 1 x 0.4 m, which is too small by itself, with
/// unassigned points next to it. These lie from `y_m` to `y_m` + 0.1 at `height_m` and were seen by
/// a sensor at the height `sensor_m`.
std::size_t floors_with_unassigned(double height_m, double sensor_m, double y_m = 0.45) {
  Scene scene;
  scene.add(patch({1.0, 0.0, 0.0}, kX, 0.4 * kY));
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
  scene.unassigned = {unassigned};
  return planes_of(scene).size();
}

TEST(AssembledPlanes, IncludeUnassignedPoints) {
  EXPECT_EQ(1u, floors_with_unassigned(0.01, 1.2));
  EXPECT_EQ(0u, floors_with_unassigned(0.06, 1.2));        // not on the plane
  EXPECT_EQ(0u, floors_with_unassigned(0.01, -1.2));       // seen from below
  EXPECT_EQ(0u, floors_with_unassigned(0.01, 1.2, 0.90));  // too far from its cells
}

}  // namespace
}  // namespace ribbon_mapper
