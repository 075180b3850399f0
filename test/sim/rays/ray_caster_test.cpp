// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ray casters against each other and against a search through all triangles, on every world that
// comes with the package.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "sim/tour/tour.hpp"
#include "test/sim/rays/caster_test.hpp"
#include "test/sim/rays/face_edges.hpp"
#include "test/sim/rays/random_rays.hpp"

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double kMaxRange_m = 30.0;
constexpr double kAgreement_m = 0.0001;

/// A ray hits an edge if, for either caster, the reported face ends or bends this close to the hit.
/// Bullet widens triangles by 1e-4 of their height, 1.5 mm for a wall of 15 m.
constexpr double kAtEdge_m = 0.002;

/// At most this share of a world's rays may be left out because they hit an edge.
constexpr double kMaxShareAtEdges = 0.02;

using Hits = std::vector<std::optional<Hit>>;

Hits cast_all(const RayCaster& caster, const std::vector<Ray>& rays) {
  Hits hits;
  for (const Ray& ray : rays) hits.push_back(caster.cast(ray, kMaxRange_m));
  return hits;
}

/// Returns the beams of every `step`-th line of the world's tour and a random ray from each line.
std::vector<Ray> rays_of_tour(const fs::path& path, const World& world, std::size_t step) {
  const Tour tour(world, Route::load(fs::path(path).replace_extension(".route.yaml").string()), {});
  std::vector<Ray> rays;
  RandomRays random;
  for (std::size_t line = 0; line < tour.line_count(); line += step) {
    const Scan scan = tour.scan(line);
    rays.insert(rays.end(), scan.rays.begin(), scan.rays.end());
    rays.push_back({scan.rays.front().origin, random.within_cube().normalized()});
  }
  return rays;
}

/// The agreement of two lists of hits of the same rays.
struct Comparison {
  std::size_t rays = 0, at_edges = 0, misses = 0;
  double largest_m = 0.0;  ///< among rays that hit no edge; a miss counts as the maximum range
};

Comparison compared(const World& world, const std::vector<Ray>& rays, const Hits& a,
                    const Hits& b) {
  const FaceEdges edges(world);
  const auto is_at_edge = [&](const Ray& ray, const std::optional<Hit>& hit) {
    return hit &&
           edges.distance_m(ray.origin + hit->range_m * ray.direction, hit->face) < kAtEdge_m;
  };
  const auto range_m = [](const std::optional<Hit>& hit) {
    return hit ? hit->range_m : kMaxRange_m;
  };
  Comparison result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ++result.rays;
    result.misses += a[i] ? 0 : 1;
    if (is_at_edge(rays[i], a[i]) || is_at_edge(rays[i], b[i]))
      ++result.at_edges;
    else
      result.largest_m = std::max(result.largest_m, std::abs(range_m(a[i]) - range_m(b[i])));
  }
  return result;
}

void expect_agreement(const std::string& name, const Comparison& c) {
  std::printf("%s: %zu rays, %zu at edges left out, %zu without a hit, others within %.1e mm\n",
              name.c_str(), c.rays, c.at_edges, c.misses, 1e3 * c.largest_m);
  EXPECT_LT(c.largest_m, kAgreement_m);
  EXPECT_LT(c.at_edges, kMaxShareAtEdges * c.rays);
  EXPECT_LT(c.misses, c.rays / 2) << "the rays must meet the world";
}

/// Returns the first hit by a search through all triangles in double precision.
std::optional<Hit> searched(const World& world, const Ray& ray) {
  std::optional<Hit> nearest;
  for (const Triangle& triangle : world.triangles()) {
    const auto& [a, b, c] = triangle.corners_m;
    const Vector3d normal = (b - a).cross(c - a);
    const double approach = normal.dot(ray.direction);
    if (approach == 0.0) continue;  // parallel to the triangle
    const double range_m = normal.dot(a - ray.origin) / approach;
    if (!(range_m > 0.0) || range_m >= (nearest ? nearest->range_m : kMaxRange_m)) continue;
    const Vector3d p = ray.origin + range_m * ray.direction;
    const bool is_inside = normal.dot((b - a).cross(p - a)) >= 0.0 &&
                           normal.dot((c - b).cross(p - b)) >= 0.0 &&
                           normal.dot((a - c).cross(p - c)) >= 0.0;
    if (is_inside) nearest = Hit{range_m, triangle.face};
  }
  return nearest;
}

std::vector<fs::path> shipped_worlds() {
  std::vector<fs::path> worlds;
  for (const auto& entry : fs::directory_iterator(PROJECT_DIR "/worlds"))
    if (entry.path().extension() == ".sdf" || entry.path().extension() == ".world")
      worlds.push_back(entry.path());
  std::sort(worlds.begin(), worlds.end());
  return worlds;
}

class CastersOnWorld : public testing::TestWithParam<fs::path> {};
INSTANTIATE_TEST_SUITE_P(Worlds, CastersOnWorld, testing::ValuesIn(shipped_worlds()),
                         [](const auto& test) { return test.param.stem().string(); });

TEST_P(CastersOnWorld, EmbreeAgreesWithBullet) {
  if (!is_available(RayCasterKind::embree)) GTEST_SKIP() << "needs the package libembree-dev";
  const World world = World::load(GetParam().string());
  const std::vector<Ray> rays = rays_of_tour(GetParam(), world, 20);
  ASSERT_GT(rays.size(), 50'000U);
  const auto hits = [&](RayCasterKind kind) {
    return cast_all(*make_ray_caster(kind, world.triangles()), rays);
  };
  expect_agreement("Embree to Bullet",
                   compared(world, rays, hits(RayCasterKind::embree), hits(RayCasterKind::bullet)));
}

TEST_P(CastersOnWorld, BulletAgreesWithASearchThroughAllTriangles) {
  const World world = World::load(GetParam().string());
  const std::vector<Ray> rays = rays_of_tour(GetParam(), world, 1000);
  Hits expected;
  for (const Ray& ray : rays) expected.push_back(searched(world, ray));
  const auto bullet = make_ray_caster(RayCasterKind::bullet, world.triangles());
  expect_agreement("Bullet to a search", compared(world, rays, cast_all(*bullet, rays), expected));
}

class Caster : public CasterTest {};
INSTANTIATE_TEST_SUITE_P(Casters, Caster, kAllCasters, caster_name);

bool are_equal(const Hits& a, const Hits& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    if (!x || !y) return !x && !y;
    return x->range_m == y->range_m && x->face == y->face;
  });
}

TEST_P(Caster, GivesTheSameBytesInEachThread) {
  const fs::path path = PROJECT_DIR "/worlds/apartment.sdf";
  const World world = World::load(path.string());
  const std::vector<Ray> rays = rays_of_tour(path, world, 200);
  const auto caster = make_ray_caster(GetParam(), world.triangles());
  const Hits expected = cast_all(*make_ray_caster(GetParam(), world.triangles()), rays);
  std::vector<Hits> found(4);
  std::vector<std::thread> threads;
  for (Hits& hits : found) threads.emplace_back([&] { hits = cast_all(*caster, rays); });
  for (std::thread& thread : threads) thread.join();
  for (const Hits& hits : found) EXPECT_TRUE(are_equal(hits, expected));
}

TEST(CasterName, IsBulletOrEmbree) {
  EXPECT_EQ(ray_caster_kind_from("bullet"), RayCasterKind::bullet);
  EXPECT_THAT([] { ray_caster_kind_from("ode"); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::AllOf(testing::HasSubstr("'ode'"), testing::HasSubstr("bullet"),
                                 testing::HasSubstr("embree"))));
}

TEST(CasterName, OfACasterThatTheBuildLacksNamesItsPackage) {
  if (is_available(RayCasterKind::embree)) {
    EXPECT_EQ(ray_caster_kind_from("embree"), RayCasterKind::embree);
    return;
  }
  const auto names_package =
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("libembree-dev"));
  EXPECT_THAT([] { ray_caster_kind_from("embree"); }, names_package);
  EXPECT_THAT([] { make_ray_caster(RayCasterKind::embree, {}); }, names_package);
}

}  // namespace
}  // namespace ribbon_mapper::sim
