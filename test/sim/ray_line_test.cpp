// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays of a line, cast together, against the same rays one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sim/tour/tour.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

void expect_same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->range_m, b->range_m);
  EXPECT_EQ(a->face, b->face);
}

TEST(RayLine, GivesTheSameBytesAsItsRaysOneByOne) {
  for (const char* name : {"apartment.sdf", "slopes.sdf", "small_office.world"}) {
    const std::string path = std::string(PROJECT_DIR "/worlds/") + name;
    const World world = World::load(path);
    Tour tour(world, Route::load(path.substr(0, path.rfind('.')) + ".route.yaml"), {});
    for (int line = 0; line < 300; ++line) {
      const Scan scan = tour.next_scan().value();
      if (line % 10 != 0) continue;
      const auto together = world.cast_line(scan.rays, 30.0);
      for (std::size_t i = 0; i < scan.rays.size(); ++i)
        expect_same(together[i], world.cast(scan.rays[i].origin, scan.rays[i].direction, 30.0));
    }
  }
}

/// Neighbours that look everywhere cost time, not truth.
TEST(RayLine, OfRaysInDisorder) {
  const Vector3d half(3, 2, 1.5);
  const World room = hollow_room(half);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (const std::size_t count : {0, 1, 3, 4, 15, 16, 17, 1000}) {
    std::vector<Ray> rays;
    while (rays.size() < count)
      rays.push_back({0.9 * half.cwiseProduct(vector()), vector().normalized()});
    const auto hits = room.cast_line(rays, 30.0);
    ASSERT_EQ(hits.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(hits[i]);
      EXPECT_NEAR(hits[i]->range_m, range_in_room(half, rays[i].origin, rays[i].direction), 1e-9);
    }
  }
}

/// Along the axes, where an inverse is infinite and a box is met edge on.
TEST(RayLine, AlongTheAxes) {
  const Vector3d half(3, 2, 1.5);
  const World room = hollow_room(half);
  std::vector<Ray> rays;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      rays.push_back({Vector3d::Zero(), sign * Vector3d::Unit(axis)});
  const auto together = room.cast_line(rays, 30.0);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(together[i]);
    EXPECT_NEAR(together[i]->range_m, half[static_cast<int>(i) / 2], 1e-12);
    expect_same(together[i], room.cast(rays[i].origin, rays[i].direction, 30.0));
  }
}

TEST(RayLine, OfTwoSurfacesInOnePlaceTheFirstIsHit) {
  const World world = world_of(sdf_block("first", {2, -1, -1}, {3, 1, 1}) +
                               sdf_block("second", {2, -1, -1}, {4, 1, 1}));
  std::vector<Ray> rays;
  for (double y = -0.9; y < 0.9; y += 0.01)
    rays.push_back({Vector3d::Zero(), Vector3d(2, y, 0.1 * y).normalized()});
  for (const auto& hit : world.cast_line(rays, 30.0)) {
    ASSERT_TRUE(hit);
    EXPECT_EQ(world.faces()[hit->face].name, "first::link::collision/-x");
  }
}

TEST(RayLine, MeshesWithoutAreaOrWithVastTrianglesAreCast) {
  const TemporaryDirectory directory;
  write_file(directory.path() / "odd.obj",
             "v 5 0 0\nv 5 0 0\nv 5 0 0\nv 6 -900 -900\nv 6 900 -900\nv 7 0 900\n"
             "f 1 2 3\nf 4 5 6\n");
  write_file(directory.path() / "w.sdf",
             sdf_world(sdf_model("odd", "0 0 0 0 0 0", sdf_mesh("odd.obj"))));
  const World world = World::load((directory.path() / "w.sdf").string());
  const auto hit = world.cast(Vector3d::Zero(), Vector3d::UnitX(), 30.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, 6.5, 1e-6);
}

}  // namespace
}  // namespace ribbon_mapper::sim
