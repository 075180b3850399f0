// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ranges of both ray casters to each kind of shape against analytic geometry.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "test/sim/rays/caster_test.hpp"
#include "test/sim/rays/random_rays.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

constexpr double kSagitta_m = 0.00019;  ///< how far round shapes may lie below their true surface
constexpr double kRounding_m = 1e-6;    ///< Bullet widens facets, so corners stick out by this

class RayRange : public CasterTest {};
INSTANTIATE_TEST_SUITE_P(Casters, RayRange, kAllCasters, caster_name);

TEST_P(RayRange, BoxFromWithin) {
  const Vector3d half(4.0, 3.0, 1.5);
  const World room = hollow_room(half, GetParam());
  RandomRays rays;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d origin = 0.9 * half.cwiseProduct(rays.within_cube());
    const Vector3d direction = rays.within_cube().normalized();
    const auto hit = room.cast(origin, direction, 30.0);
    ASSERT_TRUE(hit) << "no ray may slip through an edge";
    EXPECT_NEAR(hit->range_m, range_in_room(half, origin, direction), 1e-9);
    const Face& face = room.faces()[hit->face];
    EXPECT_NEAR(face.normal.dot(origin + hit->range_m * direction) + face.d_m, 0.0, 1e-9);
    EXPECT_LT(face.normal.dot(direction), 0.0) << "the visible side";
  }
}

TEST_P(RayRange, SolidBoxFromWithin) {
  const World world = world_of(sdf_block("box", {-1, -2, -3}, {1, 2, 3}), GetParam());
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const auto hit = world.cast({0.1, 0.2, 0.3}, sign * Vector3d::Unit(axis), 30.0);
      ASSERT_TRUE(hit) << "a face is hit from behind, too";
      EXPECT_NEAR(hit->range_m, axis + 1.0 - sign * 0.1 * (axis + 1.0), 1e-9);
    }
}

/// Returns the range to a box about the origin by the slab rule, infinite for a miss.
double range_to_box(const Vector3d& half_m, const Vector3d& o, const Vector3d& d) {
  double near_m = 0.0, far_m = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (-half_m[axis] - o[axis]) / d[axis], b = (half_m[axis] - o[axis]) / d[axis];
    near_m = std::max(near_m, std::min(a, b));
    far_m = std::min(far_m, std::max(a, b));
  }
  return near_m <= far_m ? near_m : INFINITY;
}

/// Returns true if boxes 0.5 mm smaller and larger are hit alike, on the inside of one face.
bool is_off_edges(const Vector3d& half_m, const Vector3d& o, const Vector3d& d) {
  const Vector3d margin = Vector3d::Constant(0.0005);
  const double range_m = range_to_box(half_m, o, d);
  if (std::isinf(range_to_box(half_m - margin, o, d)))
    return std::isinf(range_to_box(half_m + margin, o, d));
  return ((o + range_m * d).array().abs() > (half_m - margin).array()).count() == 1;
}

TEST_P(RayRange, TurnedBoxFromOutside) {
  const World world =
      world_of(sdf_model("box", "0.3 -0.2 0.1 0.4 -0.3 1.1", sdf_box("1 2 0.6")), GetParam());
  const Pose T_map_box =
      Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::AngleAxisd(1.1, Vector3d::UnitZ()) *
      Eigen::AngleAxisd(-0.3, Vector3d::UnitY()) * Eigen::AngleAxisd(0.4, Vector3d::UnitX());
  const Vector3d half(0.5, 1.0, 0.3);
  RandomRays rays;
  int hits = 0, at_edges = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = rays.towards_origin(5.0);
    const Vector3d o = T_map_box.inverse() * ray.origin;
    const Vector3d d = T_map_box.linear().transpose() * ray.direction;
    const bool off_edges = is_off_edges(half, o, d);
    at_edges += off_edges ? 0 : 1;
    if (!off_edges) continue;
    const double range_m = range_to_box(half, o, d);
    const auto hit = world.cast(ray.origin, ray.direction, 30.0);
    ASSERT_EQ(hit.has_value(), std::isfinite(range_m));
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->range_m, range_m, 1e-9);
  }
  EXPECT_GT(hits, 400);
  EXPECT_LT(at_edges, 20);
}

TEST_P(RayRange, Sphere) {
  const World world = world_of(
      sdf_model("ball", "0.2 0.1 -0.1 0 0 0", "<sphere><radius>0.8</radius></sphere>"), GetParam());
  const Vector3d centre(0.2, 0.1, -0.1);
  RandomRays rays;
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = rays.towards_origin(5.0);
    const double along_m = (centre - ray.origin).dot(ray.direction);
    const double miss_m = (centre - ray.origin - along_m * ray.direction).norm();
    const auto hit = world.cast(ray.origin, ray.direction, 30.0);
    ASSERT_TRUE(hit || miss_m > 0.8 - kSagitta_m);
    ASSERT_TRUE(!hit || miss_m < 0.8 + kRounding_m);
    if (!hit) continue;
    ++hits;
    EXPECT_LT(hit->range_m, along_m) << "the near side";
    const double radius_m = (ray.origin + hit->range_m * ray.direction - centre).norm();
    EXPECT_LE(radius_m, 0.8 + kRounding_m);
    EXPECT_GE(radius_m, 0.8 - kSagitta_m);
    EXPECT_FALSE(world.faces()[hit->face].planar);
  }
  EXPECT_GT(hits, 1000);
}

TEST_P(RayRange, CylinderSideAndCaps) {
  const World world =
      world_of(sdf_model("column", "1 0 0.5 0 0 0",
                         "<cylinder><radius>0.5</radius><length>2</length></cylinder>"),
               GetParam());
  for (double y = -0.45; y <= 0.45; y += 0.01) {
    const auto side = world.cast({-3, y, 0.0}, Vector3d::UnitX(), 30.0);
    ASSERT_TRUE(side);
    const double radius_m = std::hypot(side->range_m - 4.0, y);
    EXPECT_LE(radius_m, 0.5 + kRounding_m);
    EXPECT_GE(radius_m, 0.5 - kSagitta_m);
    EXPECT_FALSE(world.faces()[side->face].planar);
  }
  const auto cap = world.cast({1.2, 0.1, 4}, -Vector3d::UnitZ(), 30.0);
  ASSERT_TRUE(cap);
  EXPECT_NEAR(cap->range_m, 2.5, 1e-9);
  EXPECT_TRUE(world.faces()[cap->face].planar);
  EXPECT_FALSE(world.cast({1.51, 0, 4}, -Vector3d::UnitZ(), 30.0));
}

TEST_P(RayRange, SlopingPlane) {
  const World world =
      world_of(sdf_model("ground", "0 0 -1 0 0 0",
                         "<plane><normal>0.2 -0.1 1</normal><size>1 1</size></plane>"),
               GetParam());
  const Vector3d normal = Vector3d(0.2, -0.1, 1).normalized();
  RandomRays rays;
  for (int i = 0; i < 500; ++i) {
    const Vector3d origin = Vector3d(0, 0, 3) + rays.within_cube();
    const Vector3d direction = (Vector3d(0, 0, -1.5) + rays.within_cube()).normalized();
    const double range_m = normal.dot(Vector3d(0, 0, -1) - origin) / normal.dot(direction);
    if (range_m < 0.0 || range_m > 29.0) continue;
    const auto hit = world.cast(origin, direction, 30.0);
    ASSERT_TRUE(hit) << "the size is for display only";
    EXPECT_NEAR(hit->range_m, range_m, 1e-9);
  }
}

TEST_P(RayRange, NearestOfSeveralWithinTheMaximumRange) {
  const World world =
      world_of(sdf_block("far", {6, -1, -1}, {7, 1, 1}) + sdf_block("near", {3, -1, -1}, {4, 1, 1}),
               GetParam());
  const auto hit = world.cast(Vector3d::Zero(), Vector3d::UnitX(), 30.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 3.0, 1e-12);
  EXPECT_EQ(world.faces()[hit->face].name, "near::link::collision/-x");
  EXPECT_FALSE(world.cast(Vector3d::Zero(), Vector3d::UnitX(), 3.0 - 1e-6));
  EXPECT_TRUE(world.cast(Vector3d::Zero(), Vector3d::UnitX(), 3.0 + 1e-6));
  EXPECT_FALSE(world.cast(Vector3d::Zero(), -Vector3d::UnitX(), 30.0));
}

TEST_P(RayRange, OneOfTwoSurfacesInTheSamePlaceIsHit) {
  const World world = world_of(
      sdf_block("first", {2, -1, -1}, {3, 1, 1}) + sdf_block("second", {2, -1, -1}, {4, 1, 1}),
      GetParam());
  for (double y = -0.9; y < 0.9; y += 0.01) {
    const Vector3d direction = Vector3d(2, y, 0.1 * y).normalized();
    const auto hit = world.cast(Vector3d::Zero(), direction, 30.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->range_m, 2.0 / direction.x(), 1e-9);
    EXPECT_THAT(world.faces()[hit->face].name, testing::EndsWith("::link::collision/-x"));
  }
}

}  // namespace
}  // namespace ribbon_mapper::sim
