// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

/// Angular step and noise of the UTM-30LX, the PR2's tilting laser.
constexpr double kStep_rad = 2.0 * M_PI / 1440.0, kNoise_m = 0.01;

/// Returns beams with these ranges.
LaserBeams beams_with(std::vector<float> ranges_m) {
  LaserBeams beams;
  beams.stamp = std::chrono::seconds(1);
  beams.angle_increment_rad = kStep_rad;
  beams.range_min_m = 0.1, beams.range_max_m = 60.0;
  beams.ranges_m = std::move(ranges_m);
  return beams;
}

bool middle_is_mixed_pixel(const LaserBeams& beams, const ScanConfig& config) {
  return is_mixed_pixel(beams, 1, config, mixed_pixel_step_per_range(beams, config));
}

/// Returns the share of the returns of a plane that are taken for mixed pixels. The plane is seen
/// at 3 m under about this grazing angle.
double loss_at(double angle_deg, double mixed_pixel_angle_deg) {
  ScanConfig config;
  config.mixed_pixel_angle_deg = mixed_pixel_angle_deg;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  const double middle = angle_deg * M_PI / 180.0, distance_m = 3.0 * std::sin(middle);
  std::size_t lost = 0, all = 0;
  for (int run = 0; run < 2000; ++run) {
    std::vector<float> ranges;
    for (int i = -1; i <= 1; ++i) {
      ranges.push_back(
          static_cast<float>(distance_m / std::sin(middle + i * kStep_rad) + noise(random)));
    }
    lost += middle_is_mixed_pixel(beams_with(ranges), config), ++all;
  }
  return static_cast<double>(lost) / static_cast<double>(all);
}

TEST(MixedPixel, LiesBetweenTwoDepths) {
  const ScanConfig config;
  EXPECT_TRUE(middle_is_mixed_pixel(beams_with({2.0F, 2.5F, 3.0F}), config));
  EXPECT_TRUE(middle_is_mixed_pixel(beams_with({3.0F, 2.5F, 2.0F}), config));
  EXPECT_FALSE(middle_is_mixed_pixel(beams_with({2.0F, 2.0F, 3.0F}), config)) << "an edge";
  EXPECT_FALSE(middle_is_mixed_pixel(beams_with({2.0F, 2.5F, 2.0F}), config)) << "a thin object";
  EXPECT_FALSE(middle_is_mixed_pixel(beams_with({2.0F, 2.5F, INFINITY}), config));
  ScanConfig off;
  off.mixed_pixel_angle_deg = 0.0;
  EXPECT_FALSE(middle_is_mixed_pixel(beams_with({2.0F, 2.5F, 3.0F}), off));
}

TEST(MixedPixel, RemovesNoPointsOfPlanesThatMakeRibbons) {
  const ScanConfig config;  // 4 degrees, like ribbon.min_grazing_angle_deg
  EXPECT_LT(loss_at(20.0, config.mixed_pixel_angle_deg), 0.001);
  EXPECT_LT(loss_at(8.0, config.mixed_pixel_angle_deg), 0.01);
  for (const double angle_deg : {2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 15.0}) {
    RecordProperty("loss_percent_at_" + std::to_string(static_cast<int>(angle_deg)) + "_deg",
                   std::to_string(100.0 * loss_at(angle_deg, config.mixed_pixel_angle_deg)));
    std::printf(
        "plane seen under %4.1f deg: %5.1f %% lost with 4 deg, %5.1f %% with PR2's 10 deg\n",
        angle_deg, 100.0 * loss_at(angle_deg, 4.0), 100.0 * loss_at(angle_deg, 10.0));
  }
}

TEST(RobotBody, HasNoReturns) {
  ScanConfig config;
  config.min_range_m = 0.1;
  LinePoses poses;  // laser 1.05 m above the base, looking straight down
  for (Pose* pose : {&poses.T_base_laser_first, &poses.T_base_laser_last}) {
    *pose =
        Eigen::Translation3d(0.05, 0.0, 1.05) * Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitY());
  }
  ScanLine line;
  LaserBeams beams = beams_with({0.8F, 0.8F, 0.8F});
  beams.angle_increment_rad = 0.5;  // sideways by 0, 0.43 and 1.2 m
  poses.T_odom_base_first = poses.T_odom_base_last = planar_pose(7.0, -3.0, 1.0);
  place_beams(beams, poses, config, line);
  EXPECT_FALSE(line.has_return(0));
  EXPECT_TRUE(line.has_return(1));
  EXPECT_TRUE(line.has_return(2));
  config.body_half_size_m = 0.0;
  place_beams(beams, poses, config, line);
  EXPECT_TRUE(line.has_return(0));
}

}  // namespace
}  // namespace ribbon_mapper
