// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Number, angles and times of the beams, each of which starts from its own pose.
#include "sim/robot/hokuyo.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "sim/robot/pr2.hpp"
#include "sim/tour/tour.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

HokuyoConfig exact_laser(double half_angle_rad = 0.829) {
  HokuyoConfig config;
  config.angle_min_rad = -half_angle_rad;
  config.angle_max_rad = half_angle_rad;
  config.noise = RangeNoise::none;
  config.mixed_pixels = false;
  config.quantisation_m = 0.0;
  return config;
}

Pose standing(Time) { return Pose::Identity(); }

struct Setting {
  double half_angle_rad;
  int beams;
  double first_rad, last_rad;
};

/// hokuyo_node truncates steps, 540 being straight ahead, so the angles are not symmetric.
class BeamCount : public testing::TestWithParam<Setting> {};

TEST_P(BeamCount, AndAngles) {
  const Setting& setting = GetParam();
  const World room = hollow_room({3, 3, 3});
  Hokuyo laser(exact_laser(setting.half_angle_rad), 1);
  const Scan scan = laser.scan(room, Time(0), standing);
  ASSERT_EQ(static_cast<int>(scan.ranges_m.size()), setting.beams);
  EXPECT_EQ(laser.beam_count(), setting.beams);
  EXPECT_EQ(scan.faces.size(), scan.ranges_m.size());
  EXPECT_EQ(scan.true_ranges_m.size(), scan.ranges_m.size());
  EXPECT_NEAR(scan.angle_min_rad, setting.first_rad, 5e-5);
  EXPECT_NEAR(scan.angle_min_rad + (setting.beams - 1) * scan.angle_increment_rad, setting.last_rad,
              5e-5);
  EXPECT_NEAR(scan.angle_increment_rad, 0.0043633, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Pr2, BeamCount,
                         testing::Values(Setting{0.829, 380, -0.8290, 0.8247},
                                         Setting{1.57, 720, -1.5708, 1.5664},
                                         Setting{2.2689, 1040, -2.2689, 2.2646}));

TEST(Hokuyo, TimesOfATurnAt2400PerMinute) {
  Hokuyo laser(exact_laser(), 1);
  const Scan scan = laser.scan(hollow_room({3, 3, 3}), from_seconds(12.5), standing);
  EXPECT_EQ(scan.stamp, from_seconds(12.5)) << "the first beam's";
  EXPECT_NEAR(scan.time_increment_s, 60.0 / (2400.0 * 1440.0), 1e-12);
  EXPECT_DOUBLE_EQ(scan.scan_time_s, 0.025);
  EXPECT_EQ(laser.period(), from_seconds(0.025));
  EXPECT_NEAR(to_seconds(laser.sweep_time()), 0.0066, 5e-5) << "380 beams";
  EXPECT_NEAR(to_seconds(Hokuyo(exact_laser(1.57), 1).sweep_time()), 0.0125, 5e-5) << "720 beams";
}

TEST(Hokuyo, ASlowerRateSkipsTurns) {
  HokuyoConfig config = exact_laser();
  config.rate_hz = 20.0;
  Hokuyo laser(config, 1);
  EXPECT_EQ(laser.period(), from_seconds(0.05));
  EXPECT_NEAR(laser.scan(hollow_room({3, 3, 3}), Time(0), standing).time_increment_s, 1.736e-5,
              1e-8);
}

/// Compares a laser that moves and turns fast with the slab rule at each beam's own time.
TEST(Hokuyo, EachBeamIsCastFromItsOwnTime) {
  const Vector3d half(4, 3, 2);
  const World room = hollow_room(half);
  const auto T_map_laser = [](Time time) -> Pose {
    const double t = to_seconds(time);
    return Eigen::Translation3d(-1.0 + 2.0 * t, 0.5 * t, 0.1) *
           Eigen::AngleAxisd(3.0 * t, Vector3d::UnitZ()) *
           Eigen::AngleAxisd(-0.2 + 10.0 * t, Vector3d::UnitY()) * Pose::Identity();
  };
  Hokuyo laser(exact_laser(1.57), 1);
  double largest_shift_m = 0.0;
  for (const double stamp_s : {0.0, 0.1, 0.37}) {
    const Scan scan = laser.scan(room, from_seconds(stamp_s), T_map_laser);
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
      const double turns = static_cast<double>(i) / 1440.0;
      const double angle_rad = scan.angle_min_rad + 2.0 * M_PI * turns;
      const Vector3d beam(std::cos(angle_rad), std::sin(angle_rad), 0.0);
      const Pose own = T_map_laser(from_seconds(stamp_s + 0.025 * turns));
      const Pose first = T_map_laser(from_seconds(stamp_s));
      const double range_m = range_in_room(half, own.translation(), own.linear() * beam);
      EXPECT_NEAR(scan.ranges_m[i], range_m, 1e-5) << i;
      largest_shift_m = std::max(
          largest_shift_m,
          std::abs(range_m - range_in_room(half, first.translation(), first.linear() * beam)));
    }
  }
  EXPECT_GT(largest_shift_m, 0.05) << "otherwise this test would prove nothing";
}

/// Compares a whole tour with route, tilt and joints composed here independently.
TEST(Hokuyo, ATourSeesTheRoomFromWhereTheRobotIs) {
  const Vector3d half(6, 5, 3);
  const World room = hollow_room(half);
  TourConfig config;
  config.hokuyo = exact_laser();
  config.tilt = TiltProfileConfig::linear(1.0, 0.5, 0.1);
  Tour tour(room, Route(1.0, 1.5, {{0, 0}, {1, 0}, {1, 1}}), config);
  std::size_t lines = 0;
  for (; const auto scan = tour.next_scan(); ++lines) {
    EXPECT_EQ(scan->stamp, std::chrono::milliseconds(25) * lines);
    for (std::size_t i = 0; i < scan->ranges_m.size(); i += 7) {
      const double t = 0.025 * lines + 0.025 * static_cast<double>(i) / 1440.0;
      const double phase = std::fmod(t, 1.0);
      const double tilt_rad = 0.1 - 0.5 + (phase < 0.5 ? 2.0 * phase : 2.0 - 2.0 * phase);
      const Pose T_map_laser =
          tour.true_T_map_base(from_seconds(t)) *
          (Eigen::Translation3d(0.04893, 0, 1.017675 + 0.0115) *
           Eigen::AngleAxisd(tilt_rad, Vector3d::UnitY()) * Eigen::Translation3d(0, 0, 0.03));
      const double angle_rad = -190.0 / 1440.0 * 2.0 * M_PI + i * 2.0 * M_PI / 1440.0;
      const Vector3d beam(std::cos(angle_rad), std::sin(angle_rad), 0.0);
      ASSERT_NEAR(scan->ranges_m[i],
                  range_in_room(half, T_map_laser.translation(), T_map_laser.linear() * beam), 1e-5)
          << "line " << lines << " beam " << i;
    }
  }
  EXPECT_EQ(lines, tour.line_count());
  EXPECT_GT(lines, 100U);
}

bool same_ranges(const Scan& a, const Scan& b) {
  return a.stamp == b.stamp && a.ranges_m == b.ranges_m && a.faces == b.faces;
}

/// A line depends on its stamp and the seed, noise included, and not on the lines before it.
TEST(Hokuyo, LinesMayBeMadeInAnyOrderAndByManyThreads) {
  const World world = world_of(sdf_block("wall", {4, -9, -9}, {4.1, 9, 9}) +
                               sdf_block("board", {2, -0.3, -9}, {2.01, 0.3, 9}));
  const Hokuyo laser(HokuyoConfig(), 8);
  const auto line = [&](int k) {
    return laser.scan(world, k * laser.period(), [](Time t) -> Pose {
      return Pose(Eigen::AngleAxisd(0.1 * to_seconds(t), Vector3d::UnitZ()));
    });
  };
  constexpr int kLines = 64;
  std::vector<Scan> in_order, threaded(kLines);
  for (int k = 0; k < kLines; ++k) in_order.push_back(line(k));
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t)
    threads.emplace_back([&, t] {
      for (int k = kLines - 1 - t; k >= 0; k -= 3) threaded[k] = line(k);
    });
  for (std::thread& thread : threads) thread.join();
  for (int k = 0; k < kLines; ++k) EXPECT_TRUE(same_ranges(in_order[k], threaded[k])) << k;
  EXPECT_NE(in_order[0].ranges_m, in_order[1].ranges_m);
}

TEST(Hokuyo, NoReturnIsInfAndTooNearIsMinusInf) {
  const World world = world_of(sdf_block("wall", {4, 0, -1}, {4.1, 5, 1}) +
                               sdf_block("close", {0.05, -0.02, -1}, {0.06, -0.01, 1}));
  Hokuyo laser(exact_laser(), 1);
  const Scan scan = laser.scan(world, Time(0), standing);
  EXPECT_EQ(scan.ranges_m[100], INFINITY) << "to the right there is nothing (REP 117)";
  EXPECT_EQ(scan.faces[100], -1);
  EXPECT_EQ(scan.true_ranges_m[100], INFINITY);
  EXPECT_NEAR(scan.ranges_m[300], 4.0 / std::cos(110.0 / 1440.0 * 2.0 * M_PI), 1e-5);
  EXPECT_GE(scan.faces[300], 0);
  const int near = 190 - static_cast<int>(0.25 / 0.0043633);
  EXPECT_EQ(scan.ranges_m[near], -INFINITY) << "nearer than 0.1 m";
  EXPECT_EQ(std::count_if(scan.ranges_m.begin(), scan.ranges_m.end(),
                          [](float r) { return std::isnan(r); }),
            0);
}

TEST(Hokuyo, NothingIsSeenBeyondItsRange) {
  HokuyoConfig config = exact_laser();
  config.range_max_m = 5.0;
  Hokuyo laser(config, 1);
  const Scan scan = laser.scan(hollow_room({4, 9, 9}), Time(0), standing);
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double angle_rad = scan.angle_min_rad + i * scan.angle_increment_rad;
    EXPECT_EQ(std::isfinite(scan.ranges_m[i]), 4.0 / std::cos(angle_rad) < 5.0) << i;
  }
}

TEST(Hokuyo, RefusesImpossibleSettings) {
  const auto refused = [](const std::string& key, auto change) {
    HokuyoConfig config;
    change(config);
    EXPECT_THAT([&] { Hokuyo(config, 1); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(key)));
  };
  refused("rate", [](HokuyoConfig& c) { c.rate_hz = 41.0; });
  refused("angles", [](HokuyoConfig& c) { c.angle_max_rad = c.angle_min_rad; });
  refused("angles", [](HokuyoConfig& c) { c.angle_min_rad = -3.0; });
  refused("angle_increment", [](HokuyoConfig& c) { c.angle_increment_rad = 0.0; });
  refused("ranges", [](HokuyoConfig& c) { c.range_max_m = 0.05; });
  refused("noise_scale", [](HokuyoConfig& c) { c.noise_scale = NAN; });
  refused("quantisation", [](HokuyoConfig& c) { c.quantisation_m = -0.001; });
  EXPECT_THROW(range_noise_from("gauss"), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper::sim
