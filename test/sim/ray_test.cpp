// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ranges to each kind of shape against what geometry says.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

constexpr double kSagitta_m = 0.00019;  ///< how far round shapes may lie below their true surface

/// Rays from all around towards places near the origin.
struct Rays {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> uniform{-1.0, 1.0};

  Vector3d within_cube() { return {uniform(random), uniform(random), uniform(random)}; }
  std::pair<Vector3d, Vector3d> next(double distance_m = 5.0) {
    const Vector3d origin = distance_m * within_cube().normalized();
    return {origin, (within_cube() - origin).normalized()};
  }
};

TEST(Ray, BoxFromWithin) {
  const Vector3d half(4.0, 3.0, 1.5);
  const World room = hollow_room(half);
  Rays rays;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d origin = 0.9 * half.cwiseProduct(rays.within_cube());
    const Vector3d direction = rays.within_cube().normalized();
    const auto hit = room.cast(origin, direction, 30.0);
    ASSERT_TRUE(hit) << "no ray slips through an edge";
    EXPECT_NEAR(hit->range_m, range_in_room(half, origin, direction), 1e-9);
    const Face& face = room.faces()[hit->face];
    EXPECT_NEAR(face.normal.dot(origin + hit->range_m * direction) + face.d_m, 0.0, 1e-9);
    EXPECT_LT(face.normal.dot(direction), 0.0) << "the side that is seen";
  }
}

TEST(Ray, TurnedBoxFromOutside) {
  const World world = world_of(sdf_model("box", "0.3 -0.2 0.1 0.4 -0.3 1.1", sdf_box("1 2 0.6")));
  Pose T_map_box =
      Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::AngleAxisd(1.1, Vector3d::UnitZ()) *
      Eigen::AngleAxisd(-0.3, Vector3d::UnitY()) * Eigen::AngleAxisd(0.4, Vector3d::UnitX());
  Rays rays;
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [origin, direction] = rays.next();
    const Vector3d o = T_map_box.inverse() * origin;
    const Vector3d d = T_map_box.linear().transpose() * direction;
    double near_m = 0.0, far_m = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
      const double half_m = Vector3d(0.5, 1.0, 0.3)[axis];
      const double a = (-half_m - o[axis]) / d[axis], b = (half_m - o[axis]) / d[axis];
      near_m = std::max(near_m, std::min(a, b));
      far_m = std::min(far_m, std::max(a, b));
    }
    const auto hit = world.cast(origin, direction, 30.0);
    ASSERT_EQ(hit.has_value(), near_m <= far_m);
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->range_m, near_m, 1e-9);
  }
  EXPECT_GT(hits, 400);
}

TEST(Ray, Sphere) {
  const World world =
      world_of(sdf_model("ball", "0.2 0.1 -0.1 0 0 0", "<sphere><radius>0.8</radius></sphere>"));
  const Vector3d centre(0.2, 0.1, -0.1);
  Rays rays;
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto [origin, direction] = rays.next();
    const double along_m = (centre - origin).dot(direction);
    const double miss_m = (centre - origin - along_m * direction).norm();
    const auto hit = world.cast(origin, direction, 30.0);
    ASSERT_TRUE(hit || miss_m > 0.8 - kSagitta_m);
    if (!hit) continue;
    ++hits;
    EXPECT_LT(hit->range_m, along_m) << "the near side";
    const double radius_m = (origin + hit->range_m * direction - centre).norm();
    EXPECT_LE(radius_m, 0.8 + 1e-9);
    EXPECT_GE(radius_m, 0.8 - kSagitta_m);
    EXPECT_FALSE(world.faces()[hit->face].planar);
  }
  EXPECT_GT(hits, 1000);
}

TEST(Ray, CylinderSideAndCaps) {
  const World world = world_of(sdf_model(
      "column", "1 0 0.5 0 0 0", "<cylinder><radius>0.5</radius><length>2</length></cylinder>"));
  for (double y = -0.45; y <= 0.45; y += 0.01) {
    const auto side = world.cast({-3, y, 0.0}, Vector3d::UnitX(), 30.0);
    ASSERT_TRUE(side);
    const double radius_m = std::hypot(side->range_m - 4.0, y);
    EXPECT_LE(radius_m, 0.5 + 1e-9);
    EXPECT_GE(radius_m, 0.5 - kSagitta_m);
    EXPECT_FALSE(world.faces()[side->face].planar);
  }
  const auto cap = world.cast({1.2, 0.1, 4}, -Vector3d::UnitZ(), 30.0);
  ASSERT_TRUE(cap);
  EXPECT_NEAR(cap->range_m, 2.5, 1e-9);
  EXPECT_TRUE(world.faces()[cap->face].planar);
  EXPECT_FALSE(world.cast({1.51, 0, 4}, -Vector3d::UnitZ(), 30.0));
}

TEST(Ray, SlopingPlane) {
  const World world = world_of(sdf_model(
      "ground", "0 0 -1 0 0 0", "<plane><normal>0.2 -0.1 1</normal><size>1 1</size></plane>"));
  const Vector3d normal = Vector3d(0.2, -0.1, 1).normalized();
  Rays rays;
  for (int i = 0; i < 500; ++i) {
    const Vector3d origin = Vector3d(0, 0, 3) + rays.within_cube();
    const Vector3d direction = (Vector3d(0, 0, -1.5) + rays.within_cube()).normalized();
    const double range_m = normal.dot(Vector3d(0, 0, -1) - origin) / normal.dot(direction);
    if (range_m < 0.0 || range_m > 29.0) continue;
    const auto hit = world.cast(origin, direction, 30.0);
    ASSERT_TRUE(hit) << "the size is for the picture only";
    EXPECT_NEAR(hit->range_m, range_m, 1e-9);
  }
}

/// A pyramid over a square of 2 m, 1 m high, as ASCII STL writes it: no shared corners.
std::string stl_pyramid() {
  const char* const rim[] = {"1 1 0", "-1 1 0", "-1 -1 0", "1 -1 0"};
  std::string text = "solid pyramid\n";
  const auto facet = [&](const std::string& a, const std::string& b, const std::string& c) {
    text += "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
            "\nendloop\nendfacet\n";
  };
  for (int i = 0; i < 4; ++i) facet(rim[i], rim[(i + 1) % 4], "0 0 1");
  facet(rim[0], rim[2], rim[1]);
  facet(rim[0], rim[3], rim[2]);
  return text + "endsolid pyramid\n";
}

World pyramid_world(const std::string& scale) {
  const TemporaryDirectory directory;
  write_file(directory.path() / "pyramid.stl", stl_pyramid());
  write_file(directory.path() / "w.sdf", sdf_world(sdf_model("p", "0 0 0 0 0 0",
                                                             "<mesh><uri>pyramid.stl</uri><scale>" +
                                                                 scale + "</scale></mesh>")));
  return World::load((directory.path() / "w.sdf").string());
}

TEST(Ray, MeshHeights) {
  const World world = pyramid_world("1 1 1");
  for (double x = -0.95; x < 1.0; x += 0.1)
    for (double y = -0.97; y < 1.0; y += 0.1) {
      const auto hit = world.cast({x, y, 5}, -Vector3d::UnitZ(), 30.0);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(5.0 - hit->range_m, 1.0 - std::max(std::abs(x), std::abs(y)), 1e-6);
    }
  EXPECT_EQ(world.faces().size(), 5U) << "two triangles of the bottom are one face";
}

TEST(Ray, MeshIsScaled) {
  const auto hit = pyramid_world("2 2 0.5").cast({0, 0, 5}, -Vector3d::UnitZ(), 30.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 4.5, 1e-6);
}

TEST(Ray, NearestOfManyAndNotBeyondTheRange) {
  const World world = world_of(sdf_block("far", {6, -1, -1}, {7, 1, 1}) +
                               sdf_block("near", {3, -1, -1}, {4, 1, 1}));
  const auto hit = world.cast(Vector3d::Zero(), Vector3d::UnitX(), 30.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 3.0, 1e-12);
  EXPECT_EQ(world.faces()[hit->face].name, "near::link::collision/-x");
  EXPECT_FALSE(world.cast(Vector3d::Zero(), Vector3d::UnitX(), 2.999));
  EXPECT_TRUE(world.cast(Vector3d::Zero(), Vector3d::UnitX(), 3.001));
  EXPECT_FALSE(world.cast(Vector3d::Zero(), -Vector3d::UnitX(), 30.0));
}

/// Against every triangle of a furnished world, one by one.
TEST(Ray, TreeAgreesWithASearchThroughAllTriangles) {
  const World world = World::load(PROJECT_DIR "/worlds/apartment.sdf");
  Rays rays;
  for (int i = 0; i < 300; ++i) {
    const Vector3d origin =
        Vector3d(0, 0, 1.2) + rays.within_cube().cwiseProduct(Vector3d(7, 5, 1));
    const Vector3d direction = rays.within_cube().normalized();
    double nearest_m = 30.0;
    for (const Triangle& triangle : world.triangles()) {
      const auto& [a, b, c] = triangle.corners_m;
      const Vector3d normal = (b - a).cross(c - a);
      const double range_m = normal.dot(a - origin) / normal.dot(direction);
      if (!(range_m > 0.0) || range_m >= nearest_m) continue;
      const Vector3d p = origin + range_m * direction;
      const bool inside = normal.dot((b - a).cross(p - a)) >= 0.0 &&
                          normal.dot((c - b).cross(p - b)) >= 0.0 &&
                          normal.dot((a - c).cross(p - c)) >= 0.0;
      if (inside) nearest_m = range_m;
    }
    const auto hit = world.cast(origin, direction, 30.0);
    EXPECT_NEAR(hit ? hit->range_m : 30.0, nearest_m, 1e-9);
  }
}

}  // namespace
}  // namespace ribbon_mapper::sim
