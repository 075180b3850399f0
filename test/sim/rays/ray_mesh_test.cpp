// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays into meshes, along faces and at grazing angles, with both ray casters.
#include <gtest/gtest.h>

#include <cmath>

#include "test/sim/rays/caster_test.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

class RayMesh : public CasterTest {
 protected:
  static World world_of_mesh(const std::string& file, const std::string& content,
                             const std::string& scale = "1 1 1") {
    const TemporaryDirectory directory;
    write_file(directory.path() / file, content);
    const std::string mesh = "<mesh><uri>" + file + "</uri><scale>" + scale + "</scale></mesh>";
    write_file(directory.path() / "w.sdf", sdf_world(sdf_model("mesh", "0 0 0 0 0 0", mesh)));
    return World::load((directory.path() / "w.sdf").string(), {}, GetParam());
  }
};
INSTANTIATE_TEST_SUITE_P(Casters, RayMesh, kAllCasters, caster_name);

/// Returns a pyramid over a square of 2 m, 1 m high, in ASCII STL: triangles share no corners.
std::string stl_pyramid() {
  const char* const rim[] = {"1 1 0", "-1 1 0", "-1 -1 0", "1 -1 0"};
  std::string text = "solid pyramid\n";
  const auto triangle = [&](const std::string& a, const std::string& b, const std::string& c) {
    text += "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
            "\nendloop\nendfacet\n";
  };
  for (int i = 0; i < 4; ++i) triangle(rim[i], rim[(i + 1) % 4], "0 0 1");
  triangle(rim[0], rim[2], rim[1]);
  triangle(rim[0], rim[3], rim[2]);
  return text + "endsolid pyramid\n";
}

TEST_P(RayMesh, Heights) {
  const World world = world_of_mesh("pyramid.stl", stl_pyramid());
  for (double x = -0.95; x < 1.0; x += 0.1)
    for (double y = -0.97; y < 1.0; y += 0.1) {
      const auto hit = world.cast({x, y, 5}, -Vector3d::UnitZ(), 30.0);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(5.0 - hit->range_m, 1.0 - std::max(std::abs(x), std::abs(y)), 1e-6);
    }
  EXPECT_EQ(world.faces().size(), 5U) << "the two triangles of the bottom are one face";
}

TEST_P(RayMesh, IsScaled) {
  const World world = world_of_mesh("pyramid.stl", stl_pyramid(), "2 2 0.5");
  const auto hit = world.cast({0, 0, 5}, -Vector3d::UnitZ(), 30.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 4.5, 1e-4) << "at the very tip, which Bullet widens";
}

TEST_P(RayMesh, TrianglesWithoutAreaAreIgnoredAndVastOnesAreHit) {
  const World world = world_of_mesh("odd.obj",
                                    "v 5 0 0\nv 5 0 0\nv 5 0 0\n"
                                    "v 6 -900 -900\nv 6 900 -900\nv 7 0 900\n"
                                    "f 1 2 3\nf 4 5 6\n");
  const auto hit = world.cast(Vector3d::Zero(), Vector3d::UnitX(), 30.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 6.5, 1e-6);
}

class RayAlongFaces : public CasterTest {
 protected:
  const Vector3d half{3, 2, 1.5};
  World room() const { return hollow_room(half, GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Casters, RayAlongFaces, kAllCasters, caster_name);

TEST_P(RayAlongFaces, AxesAreExact) {
  const World room = this->room();
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const auto hit = room.cast(Vector3d::Zero(), sign * Vector3d::Unit(axis), 30.0);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->range_m, half[axis], 1e-12);
    }
}

TEST_P(RayAlongFaces, AParallelRayMeetsTheWallAhead) {
  const World room = this->room();
  for (const double height_m : {0.0, 1e-9, 1e-6, 1e-3}) {
    const auto hit = room.cast({0.3, 0.2, -half.z() + height_m}, Vector3d::UnitX(), 30.0);
    ASSERT_TRUE(hit) << height_m;
    EXPECT_NEAR(hit->range_m, half.x() - 0.3, 1e-4) << height_m;
  }
}

/// Starts 0.2 mm to 0.5 m above the floor, with slopes down to a hundredth of a degree.
TEST_P(RayAlongFaces, AGrazingRayMeetsTheFloorWhereGeometrySays) {
  const World room = this->room();
  for (const double slope : {0.1, 0.01, 0.001, 0.0002})
    for (const double way_m : {1.0, 2.5, 5.0}) {
      const Vector3d direction = Vector3d(1.0, 0.1, -slope).normalized();
      const Vector3d origin(-half.x() + 0.2, -0.3, -half.z() + slope * way_m);
      const auto hit = room.cast(origin, direction, 30.0);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->range_m, way_m / direction.x(), 1e-4) << slope << " " << way_m;
      EXPECT_GT(room.faces()[hit->face].normal.z(), 0.5) << slope << " " << way_m;
    }
}

}  // namespace
}  // namespace ribbon_mapper::sim
