// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/tour.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "sim/robot/pr2.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

const Eigen::Vector3d kHalf_m(3, 2, 1.5);
const Route kRoute(0.5, 1.0, {{-1, 0}, {1, 0}});

/// A room with a post, which has depth edges.
World room_with_post() {
  return world_of(sdf_block("floor", {-4, -3, -0.1}, {4, 3, 0}) +
                  sdf_block("wall", {3, -3, 0}, {3.1, 3, 2.5}) +
                  sdf_block("post", {2, 0.6, 0}, {2.1, 0.7, 2}));
}

std::vector<Scan> scans_of(const World& world, std::uint64_t seed) {
  TourConfig config;
  config.seed = seed;
  Tour tour(world, kRoute, config);
  std::vector<Scan> scans;
  while (auto scan = tour.next_scan()) scans.push_back(std::move(*scan));
  return scans;
}

bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(Tour, SameSeedSameBytes) {
  const World world = room_with_post(), again = room_with_post();
  const auto first = scans_of(world, 4), second = scans_of(again, 4), other = scans_of(world, 5);
  ASSERT_EQ(first.size(), second.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].stamp, second[i].stamp);
    EXPECT_TRUE(same_bytes(first[i].ranges_m, second[i].ranges_m)) << i;
    EXPECT_TRUE(same_bytes(first[i].true_ranges_m, second[i].true_ranges_m)) << i;
    EXPECT_EQ(first[i].faces, second[i].faces) << i;
    EXPECT_TRUE(same_bytes(first[i].true_ranges_m, other[i].true_ranges_m)) << "no noise in these";
    different += same_bytes(first[i].ranges_m, other[i].ranges_m) ? 0 : 1;
  }
  EXPECT_GT(different, first.size() * 9 / 10) << "all but those without any return";
}

TEST(Tour, AnyLineIsTheOneThatComesInItsTurn) {
  const World world = room_with_post();
  const auto scans = scans_of(world, 1);
  const Tour tour(world, kRoute, {});
  for (const std::size_t line : {100, 7, 0, 150}) {
    const Scan scan = tour.scan(line);
    EXPECT_EQ(scan.stamp, scans[line].stamp);
    EXPECT_TRUE(same_bytes(scan.ranges_m, scans[line].ranges_m));
  }
}

TEST(Tour, LinesEndBeforeTheRouteDoes) {
  const World world = room_with_post();
  Tour tour(world, kRoute, {});
  const auto scans = scans_of(world, 1);
  EXPECT_EQ(scans.size(), tour.line_count());
  const Time last = scans.back().stamp;
  const Time sweep = from_seconds(379 * 60.0 / (2400.0 * 1440.0));
  EXPECT_LE(last + sweep, tour.duration());
  EXPECT_GT(last + sweep + from_seconds(0.025), tour.duration());
}

TEST(Tour, PosesFitTogether) {
  const World world = room_with_post();
  Tour tour(world, kRoute, {});
  const Time t = from_seconds(1.234);
  EXPECT_TRUE(tour.noisy_T_map_base(t).isApprox(tour.T_map_odom(t) * tour.T_odom_base(t), 1e-12));
  EXPECT_TRUE(tour.T_base_laser(t).isApprox(pr2::T_base_laser(tour.tilt_angle(t)), 1e-12));
  EXPECT_TRUE(tour.true_T_map_base(t).isApprox(kRoute.T_map_base(t), 1e-12));
}

TEST(Tour, IsRefusedIfTheRouteCollides) {
  const World world = world_of(sdf_block("wall", {0, -3, 0}, {0.1, 3, 2.5}));
  EXPECT_THROW(Tour(world, kRoute, {}), std::runtime_error);
}

TEST(Tour, IsRefusedWithABadValueEvenIfTheWorldIsFree) {
  const World world = room_with_post();
  TourConfig config;
  config.localisation.drift = -1.0;
  EXPECT_THROW(Tour(world, kRoute, config), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper::sim
