// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/tour.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(Tour, OdometryBeginsAtTheTruePose) {
  const World world = room_with_post();
  const Tour tour(world, kRoute, {});
  EXPECT_TRUE((tour.T_map_odom_at_start() * tour.T_odom_base(Time(0)))
                  .isApprox(tour.true_T_map_base(Time(0)), 1e-12));
}

/// The beams in closed form: from 0.275 m ahead of the base's centre and 0.303 m above the floor,
/// each at its own time, level, a quarter of a degree apart from -130 to +130 degrees.
TEST(Tour, TheBaseLaserScansLevelAllAround) {
  const World room = hollow_room(kHalf_m);
  TourConfig config;
  config.base_hokuyo.noise = RangeNoise::none;
  config.base_hokuyo.mixed_pixels = false;
  config.base_hokuyo.quantisation_m = 0.0;
  const Tour tour(room, kRoute, config);
  constexpr double kStep_rad = M_PI / 720.0, kBeamStep_s = 60.0 / (2400.0 * 1440.0);
  for (const std::size_t line : {0, 17, 100}) {
    const Scan scan = tour.base_scan(line);
    EXPECT_NEAR(to_seconds(scan.stamp), 0.025 * static_cast<double>(line), 1e-9) << "40 Hz";
    EXPECT_NEAR(scan.scan_time_s, 0.025, 1e-12);
    EXPECT_NEAR(scan.time_increment_s, kBeamStep_s, 1e-12);
    EXPECT_NEAR(scan.angle_min_rad, -520 * kStep_rad, 1e-9);
    ASSERT_EQ(scan.ranges_m.size(), 1040U);
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
      const Time at = scan.stamp + from_seconds(static_cast<double>(i) * kBeamStep_s);
      const double angle_rad = (static_cast<double>(i) - 520.0) * kStep_rad;
      const Pose T_map_base = kRoute.T_map_base(at);
      const Eigen::Vector3d origin = T_map_base * Eigen::Vector3d(0.275, 0.0, 0.303),
                            beam = T_map_base.linear() *
                                   Eigen::Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0.0);
      ASSERT_NEAR(scan.ranges_m[i], range_in_room(kHalf_m, origin, beam), 1e-5) << line << " " << i;
    }
  }
}

TEST(Tour, TheBaseLaserLeavesTheTiltingOneAsItIs) {
  const World world = room_with_post();
  const auto alone = scans_of(world, 3);
  TourConfig config;
  config.seed = 3;
  Tour tour(world, kRoute, config);
  for (std::size_t line = 0; line < alone.size(); ++line) {
    if (line < tour.base_line_count()) tour.base_scan(line);
    const auto scan = tour.next_scan();
    ASSERT_TRUE(scan);
    EXPECT_TRUE(same_bytes(scan->ranges_m, alone[line].ranges_m)) << line;
  }
}

/// Returns the correlation of the range noise of two lines, 0 for independent ones.
double noise_correlation(const Scan& a, const Scan& b) {
  double products = 0.0, squares_a = 0.0, squares_b = 0.0;
  for (std::size_t i = 0; i < a.ranges_m.size(); ++i) {
    const double error_a = a.ranges_m[i] - a.true_ranges_m[i],
                 error_b = b.ranges_m.at(i) - b.true_ranges_m[i];
    products += error_a * error_b;
    squares_a += error_a * error_a;
    squares_b += error_b * error_b;
  }
  return products / std::sqrt(squares_a * squares_b);
}

/// Both lasers get the same beams here. 380 independent pairs correlate by 0.05.
TEST(Tour, TheBaseLaserHasItsOwnNoise) {
  const World room = hollow_room(kHalf_m);
  TourConfig config;
  config.hokuyo.mixed_pixels = false;
  config.base_hokuyo = config.hokuyo;
  const Tour tour(room, kRoute, config);
  config.seed = 2;
  const Tour other(room, kRoute, config);
  const Scan scan = tour.base_scan(7);
  EXPECT_GT(noise_correlation(scan, tour.base_scan(7)), 0.99);
  EXPECT_LT(std::abs(noise_correlation(scan, tour.scan(7))), 0.3);
  EXPECT_LT(std::abs(noise_correlation(scan, tour.base_scan(8))), 0.3);
  EXPECT_LT(std::abs(noise_correlation(scan, other.base_scan(7))), 0.3);
}

TEST(Tour, LinesOfTheBaseLaserEndBeforeTheRouteDoes) {
  const World world = room_with_post();
  const Tour tour(world, kRoute, {});
  const std::size_t last = tour.base_line_count() - 1;
  EXPECT_LE(tour.base_scan_end(last), tour.duration());
  EXPECT_GT(tour.base_scan_end(last + 1), tour.duration());
  const Scan scan = tour.base_scan(last);
  EXPECT_NEAR(to_seconds(tour.base_scan_end(last) - scan.stamp), 1039 * scan.time_increment_s,
              1e-7);
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
