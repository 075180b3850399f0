// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Statistics of noise, quantisation and mixed pixels.
#include <gtest/gtest.h>

#include <functional>

#include "sim/robot/hokuyo.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

struct Case {
  const char* name;
  double distance_m;
  double sigma_m;  ///< from the sources, independent of the code
};

/// A wall seen by beams within +-0.2 rad, whose ranges differ by 2 %.
class RangeSigma : public testing::TestWithParam<Case> {};

TEST_P(RangeSigma, IsThatOfItsSource) {
  const Case& sample = GetParam();
  const World world =
      world_of(sdf_block("wall", {sample.distance_m, -9, -9}, {sample.distance_m + 0.1, 9, 9}));
  HokuyoConfig config;
  config.angle_min_rad = -0.2;
  config.angle_max_rad = 0.2;
  config.noise = range_noise_from(sample.name);
  config.quantisation_m = 0.0;
  Hokuyo laser(config, 11);
  double sum = 0.0, squares = 0.0;
  int count = 0, within = 0;
  for (int line = 0; line < 400; ++line) {
    const Scan scan = laser.scan(world, Time(line), [](Time) { return Pose::Identity(); });
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i, ++count) {
      const double error_m = static_cast<double>(scan.ranges_m[i]) - scan.true_ranges_m[i];
      sum += error_m;
      squares += error_m * error_m;
      within += std::abs(error_m) < sample.sigma_m ? 1 : 0;
    }
  }
  const double root = std::sqrt(static_cast<double>(count));  // 36400 beams
  EXPECT_NEAR(sum / count, 0.0, 5.0 * sample.sigma_m / root) << "unbiased";
  EXPECT_NEAR(std::sqrt(squares / count) / sample.sigma_m, 1.0, 5.0 * std::sqrt(0.5) / root + 0.01);
  EXPECT_NEAR(static_cast<double>(within) / count, 0.6827, 0.015) << "Gaussian";
}

INSTANTIATE_TEST_SUITE_P(Sources, RangeSigma,
                         testing::Values(Case{"gazebo", 3.0, 0.005}, Case{"gazebo", 20.0, 0.005},
                                         Case{"datasheet", 9.5, 0.01},
                                         Case{"datasheet", 10.5, 0.03},
                                         Case{"pomerleau", 5.0, 0.018},
                                         Case{"pomerleau", 29.0, 0.0006 * 29.2 + 0.0015}));

TEST(RangeNoise, NoneIsExactAndScaleMultiplies) {
  const World world = world_of(sdf_block("wall", {3, -9, -9}, {3.1, 9, 9}));
  HokuyoConfig config;
  config.quantisation_m = 0.0;
  config.noise_scale = 0.0;
  const auto standing = [](Time) { return Pose::Identity(); };
  const Scan exact = Hokuyo(config, 3).scan(world, Time(0), standing);
  EXPECT_EQ(exact.ranges_m, exact.true_ranges_m);
  config.noise_scale = 1.0;
  const Scan once = Hokuyo(config, 3).scan(world, Time(0), standing);
  config.noise_scale = 4.0;
  const Scan fourfold = Hokuyo(config, 3).scan(world, Time(0), standing);
  for (std::size_t i = 0; i < once.ranges_m.size(); ++i)
    EXPECT_NEAR(fourfold.ranges_m[i] - exact.ranges_m[i],
                4.0 * (once.ranges_m[i] - exact.ranges_m[i]), 1e-5);
}

TEST(RangeNoise, RangesAreWholeMillimetres) {
  const World world = world_of(sdf_block("wall", {3, -9, -9}, {3.1, 9, 9}));
  for (const double step_m : {0.001, 0.01}) {
    HokuyoConfig config;
    config.quantisation_m = step_m;
    const Scan scan = Hokuyo(config, 3).scan(world, Time(0), [](Time) { return Pose::Identity(); });
    for (const float range_m : scan.ranges_m)
      EXPECT_NEAR(range_m / step_m, std::round(range_m / step_m), 1e-3);
  }
}

/// A board of 0.6 m, 2 m ahead, in front of a wall 4 m ahead.
class MixedPixels : public testing::Test {
 protected:
  Scan scan_from(const Hokuyo& laser, int line) const {
    const double y_m = 0.0007 * line;
    return laser.scan(world_, Time(line),
                      [y_m](Time) -> Pose { return Pose(Eigen::Translation3d(0, y_m, 0)); });
  }
  static HokuyoConfig config(bool mixed) {
    HokuyoConfig config;
    config.noise = RangeNoise::none;
    config.quantisation_m = 0.0;
    config.mixed_pixels = mixed;
    return config;
  }
  World world_ = world_of(sdf_block("wall", {4, -9, -9}, {4.1, 9, 9}) +
                          sdf_block("board", {2, -0.3, -9}, {2.01, 0.3, 9}));
};

TEST_F(MixedPixels, OnlyAtEdgesOneBeamEachBetweenTheTwoDepths) {
  Hokuyo laser(config(true), 5);
  double share_sum = 0.0;
  int mixed = 0, edges = 0;
  for (int line = 0; line < 300; ++line) {
    const Scan scan = scan_from(laser, line);
    for (std::size_t i = 1; i + 1 < scan.ranges_m.size(); ++i) {
      const double own_m = scan.true_ranges_m[i];
      const double jump_m = std::abs(scan.true_ranges_m[i + 1] - own_m);
      edges += jump_m > 0.05 ? 1 : 0;
      if (scan.ranges_m[i] == scan.true_ranges_m[i]) continue;
      ++mixed;
      const double left_m = scan.true_ranges_m[i - 1], right_m = scan.true_ranges_m[i + 1];
      const double other_m =
          std::abs(left_m - own_m) > std::abs(right_m - own_m) ? left_m : right_m;
      ASSERT_GT(std::abs(other_m - own_m), 0.05) << "away from any edge: beam " << i;
      const double share = (scan.ranges_m[i] - own_m) / (other_m - own_m);
      EXPECT_GT(share, 0.0);
      EXPECT_LT(share, 0.52) << "its own surface takes the larger part";
      share_sum += share;
    }
  }
  EXPECT_EQ(edges, 600);
  EXPECT_NEAR(mixed, 600, 6) << "the rim between two beams belongs to one of them";
  EXPECT_NEAR(share_sum / mixed, 0.25, 0.03);
}

TEST_F(MixedPixels, CanBeSwitchedOff) {
  Hokuyo laser(config(false), 5);
  for (int line = 0; line < 20; ++line) {
    const Scan scan = scan_from(laser, line);
    EXPECT_EQ(scan.ranges_m, scan.true_ranges_m);
  }
}

}  // namespace
}  // namespace ribbon_mapper::sim
