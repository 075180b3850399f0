// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Truth planes of small worlds, scanned densely from given places.
#include "sim/truth/truth.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

/// Casts rays in all directions, a third of a degree apart, so that each cell of 5 cm up to 6 m
/// away is hit. Returns the planes seen.
std::vector<TruthPlane> seen_from(const World& world, const std::vector<Vector3d>& places,
                                  double min_area_m2 = 0.5) {
  TruthCollector truth(world);
  const double step_rad = M_PI / 540.0;
  for (const Vector3d& place : places)
    for (double up = step_rad / 2 - M_PI / 2; up < M_PI / 2; up += step_rad)
      for (double round = step_rad / 2; round < 2.0 * M_PI; round += step_rad) {
        const Vector3d beam(std::cos(up) * std::cos(round), std::cos(up) * std::sin(round),
                            std::sin(up));
        if (const auto hit = world.cast(place, beam, 30.0))
          truth.add(place + hit->range_m * beam, place, hit->face);
      }
  return truth.planes(min_area_m2);
}

/// Returns a wall of 2 m height from x_begin to x_end whose near side lies at `y_m`.
std::string wall(const std::string& name, double x_begin_m, double x_end_m, double y_m = 2.0) {
  return sdf_block(name, {x_begin_m, y_m, 0.0}, {x_end_m, y_m + 0.1, 2.0});
}

const Vector3d kInFront(0.0, 0.0, 1.0);

TEST(Truth, ARoomHasSixPlanes) {
  const auto planes = seen_from(hollow_room({2, 1.5, 1}), {Vector3d(0.1, 0.2, -0.1)});
  ASSERT_EQ(planes.size(), 6U);
  double area_m2 = 0.0;
  for (const TruthPlane& plane : planes) {
    area_m2 += plane.area_m2;
    EXPECT_LT(plane.normal.dot(-plane.d_m * plane.normal), 0.0) << "looks inwards";
    EXPECT_NEAR(plane.area_m2, 0.0025 * static_cast<double>(plane.cells.size()), 1e-9);
    for (const Vector3d& cell : plane.cells)
      ASSERT_NEAR(plane.normal.dot(cell) + plane.d_m, 0.0, 1e-9);
  }
  EXPECT_NEAR(area_m2, 2 * (4 * 3 + 4 * 2 + 3 * 2), 0.3);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_EQ(planes[i].id, static_cast<int>(i));
    EXPECT_GE(planes[i > 0 ? i - 1 : 0].area_m2, planes[i].area_m2) << "largest first";
  }
}

TEST(Truth, TwoSidesOfAThinWallAreTwoPlanes) {
  const World world = world_of(wall("wall", -1, 1));
  const auto front = seen_from(world, {kInFront});
  ASSERT_EQ(front.size(), 1U) << "the back was not seen; ends and top are too small";
  EXPECT_TRUE(front[0].normal.isApprox(-Vector3d::UnitY(), 1e-9));
  EXPECT_NEAR(front[0].d_m, 2.0, 1e-9);
  const auto both = seen_from(world, {kInFront, Vector3d(0.0, 4.0, 1.0)});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NEAR(both[0].normal.dot(both[1].normal), -1.0, 1e-9);
  EXPECT_NEAR(both[0].d_m + both[1].d_m, -0.1, 1e-9) << "10 cm apart";
}

/// A sheet without thickness has two sides nevertheless.
TEST(Truth, AnOpenMeshIsSeenFromBothSides) {
  const TemporaryDirectory directory;
  write_file(directory.path() / "sheet.obj",
             "v -1 2 0\nv 1 2 0\nv 1 2 2\nv -1 2 2\nf 1 2 3\nf 1 3 4\n");
  write_file(directory.path() / "w.sdf",
             sdf_world(sdf_model("sheet", "0 0 0 0 0 0", sdf_mesh("sheet.obj"))));
  const World world = World::load((directory.path() / "w.sdf").string());
  const auto planes = seen_from(world, {kInFront, Vector3d(0.0, 4.0, 1.0)});
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_NEAR(planes[0].normal.dot(planes[1].normal), -1.0, 1e-9);
  EXPECT_NEAR(planes[0].d_m + planes[1].d_m, 0.0, 1e-6);
}

TEST(Truth, GapsOfUpToAMetreAreBridged) {
  const auto planes_with_gap = [](double gap_m) {
    return seen_from(world_of(wall("a", -2, 0) + wall("b", gap_m, 2)), {kInFront}).size();
  };
  EXPECT_EQ(planes_with_gap(0.9), 1U) << "a wall with a door in it";
  EXPECT_EQ(planes_with_gap(1.1), 2U);
}

TEST(Truth, TopsOfFurnitureAreBridgedAsFarAsLinesLeaveGaps) {
  const auto planes = [](double gap_m, double z_m) {
    const World world = world_of(sdf_block("a", {-2, 1, z_m - 0.05}, {0, 2, z_m}) +
                                 sdf_block("b", {gap_m, 1, z_m - 0.05}, {2, 2, z_m}));
    return seen_from(world, {Vector3d(0.0, 0.0, z_m + 1.0)}).size();
  };
  EXPECT_EQ(planes(0.25, 0.75), 1U);
  EXPECT_EQ(planes(0.40, 0.75), 2U) << "two tables of one height";
  EXPECT_EQ(planes(0.40, 0.10), 1U) << "floor";
  EXPECT_EQ(planes(1.60, 0.75), 1U) << "one is too small: 0.4 m2, and far";
}

TEST(Truth, PatchesOfHalfASquareMetreOrMore) {
  const auto planes_of = [](double side_m, double min_area_m2) {
    const World world = world_of(sdf_block("board", {0, 2, 0.5}, {side_m, 2.1, 0.5 + side_m}));
    return seen_from(world, {kInFront}, min_area_m2).size();
  };
  EXPECT_EQ(planes_of(0.70, 0.5), 0U) << "0.49 m2";
  EXPECT_EQ(planes_of(0.75, 0.5), 1U) << "0.5625 m2";
  EXPECT_EQ(planes_of(0.70, 0.4), 1U);
}

TEST(Truth, LidsArePlanesCurvedSurfacesAreNot) {
  const World world =
      world_of(sdf_model("ball", "0 3 1 0 0 0", "<sphere><radius>1</radius></sphere>") +
               sdf_model("drum", "3 0 0 0 0 0",
                         "<cylinder><radius>1</radius><length>1.5</length></cylinder>"));
  const auto planes = seen_from(world, {Vector3d(0, 0, 1.5), Vector3d(3, -2, 2)});
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_TRUE(planes[0].normal.isApprox(Vector3d::UnitZ(), 1e-9));
  EXPECT_NEAR(planes[0].d_m, -0.75, 1e-9);
}

TEST(Truth, OffsetsWithinACentimetreAreOnePlane) {
  const auto planes_with_offset = [](double offset_m) {
    return seen_from(world_of(wall("a", -1, 0) + wall("b", 0, 1, 2.0 + offset_m)), {kInFront})
        .size();
  };
  EXPECT_EQ(planes_with_offset(0.009), 1U);
  EXPECT_EQ(planes_with_offset(0.011), 2U);
}

TEST(Truth, NormalsWithinHalfADegreeAreOnePlane) {
  const auto planes_with_turn = [](const std::string& yaw_rad) {
    // Turned about the middle line of the wall, where it is nearest to the origin.
    const std::string turned = sdf_model("b", "0 2.05 3.5 0 0 " + yaw_rad, sdf_box("2 0.1 2"));
    return seen_from(world_of(sdf_block("a", {-1, 2, 0}, {1, 2.1, 2}) + turned), {kInFront}).size();
  };
  EXPECT_EQ(planes_with_turn("0.00698"), 1U) << "0.4 degrees";
  EXPECT_EQ(planes_with_turn("0.01047"), 2U) << "0.6 degrees";
}

TEST(Truth, OnlyWhatBeamsHitCounts) {
  const World world = world_of(wall("wall", -1, 1));
  TruthCollector truth(world);
  EXPECT_TRUE(truth.planes().empty());
  truth.add(Vector3d(0, 2, 1), kInFront, -1);
  EXPECT_TRUE(truth.planes(0.0).empty()) << "no face, no hit";
}

}  // namespace
}  // namespace ribbon_mapper::sim
