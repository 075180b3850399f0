// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modeler/modeler.hpp"
#include "modeler/scan/line_averaging.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kNoise_m = 0.01, kWall_m = 2.0;

Pose T_base_laser(double tilt_rad) {
  return Eigen::Translation3d(0.0, 0.0, 1.2) *
         Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitY());
}

/// Returns line number `index` of a wall at x = 2 m, with one beam more than `steps`.
LaserBeams wall_line(int index, double tilt_rad, std::mt19937& random, int steps = 200) {
  std::normal_distribution<double> noise(0.0, kNoise_m);
  LaserBeams beams;
  beams.stamp = std::chrono::milliseconds(1000 + 100 * index);
  beams.angle_min_rad = -0.6, beams.angle_increment_rad = 1.2 / steps;
  beams.range_min_m = 0.1, beams.range_max_m = 10.0;
  for (int i = 0; i <= steps; ++i) {
    const double angle = beams.angle_min_rad + i * beams.angle_increment_rad;
    beams.ranges_m.push_back(
        static_cast<float>(kWall_m / (std::cos(tilt_rad) * std::cos(angle)) + noise(random)));
  }
  return beams;
}

/// Returns the poses of a line at a constant tilt.
LinePoses poses_at(double tilt_rad) {
  LinePoses poses;
  poses.T_base_laser_first = poses.T_base_laser_last = T_base_laser(tilt_rad);
  return poses;
}

/// Returns the configuration for this laser.
ModelerConfig config() {
  ModelerConfig config;
  config.scan.range_sigma_m = kNoise_m;
  config.scan.base_line_sigmas = 3.0;
  return config;
}

TEST(LineAverager, ReducesNoise) {
  std::mt19937 random(1);
  LineAverager averager(config().scan);
  for (int i = 0; i < 9; ++i) averager.add(wall_line(i, 0.1, random), poses_at(0.1));
  double square = 0.0;
  const LaserBeams& mean = averager.average_beams();
  for (std::size_t i = 0; i < mean.ranges_m.size(); ++i) {
    const double angle = mean.angle_min_rad + i * mean.angle_increment_rad;
    const double error = mean.ranges_m[i] - kWall_m / (std::cos(0.1) * std::cos(angle));
    square += error * error / mean.ranges_m.size();
  }
  EXPECT_NEAR(std::sqrt(square), kNoise_m / 3.0, 0.1 * kNoise_m);
  EXPECT_EQ(mean.stamp, std::chrono::milliseconds(1400));
}

TEST(LineAverager, AveragesThePoses) {
  std::mt19937 random(1);
  LineAverager averager(config().scan);
  for (const double tilt : {0.10, 0.11, 0.12})
    averager.add(wall_line(0, tilt, random), poses_at(tilt));
  EXPECT_NEAR(angle_of(averager.mean_poses().T_base_laser_first), 0.11, 1e-6);
}

TEST(LineAverager, RemovesBeamsWhoseReturnsDisagree) {
  std::mt19937 random(1);
  LineAverager averager(config().scan);
  for (int i = 0; i < 4; ++i) {
    LaserBeams beams = wall_line(i, 0.1, random);
    beams.ranges_m[50] = i % 2 ? 1.0F : 3.0F;  // an edge
    if (i > 0) beams.ranges_m[60] = std::numeric_limits<float>::infinity();
    averager.add(beams, poses_at(0.1));
  }
  EXPECT_TRUE(std::isinf(averager.average_beams().ranges_m[50]));
  EXPECT_TRUE(std::isfinite(averager.average_beams().ranges_m[60]))
      << "a missing return does not contradict one";
}

/// Models lines 0.07 degrees apart, or 2.4 mm on the wall: a quarter of the noise.
TEST(DenseLines, OfAWallMakeOnePlane) {
  std::mt19937 random(1);
  Modeler modeler(config());
  for (int i = 0; i < 600; ++i) {
    const double tilt = -0.3 + 0.07 * M_PI / 180.0 * i;
    modeler.add_scan_line(wall_line(i, tilt, random), poses_at(tilt));
  }
  modeler.correct(modeler.trajectory());
  const std::vector<Plane> planes = modeler.planes();
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_GT(-planes[0].normal.x(), std::cos(0.01));
  EXPECT_NEAR(planes[0].d_m, kWall_m, 0.005);
  EXPECT_GT(planes[0].area_m2, 3.0);
}

/// The same laser with another number of beams in each line.
TEST(DenseLines, OfAnotherLengthEachAreAveraged) {
  std::mt19937 random(1);
  Modeler modeler(config());
  for (int i = 0; i < 600; ++i) {
    const double tilt = -0.3 + 0.07 * M_PI / 180.0 * i;
    modeler.add_scan_line(wall_line(i, tilt, random, 190 + i % 20), poses_at(tilt));
  }
  modeler.correct(modeler.trajectory());
  const std::vector<Plane> planes = modeler.planes();
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_GT(-planes[0].normal.x(), std::cos(0.01));
  EXPECT_NEAR(planes[0].d_m, kWall_m, 0.005);
  EXPECT_GT(planes[0].area_m2, 3.0);
}

TEST(LineAverager, InterpolatesBeamsOfAnotherBearing) {
  std::mt19937 random(1);
  LineAverager averager(config().scan);
  for (int i = 0; i < 9; ++i) averager.add(wall_line(i, 0.1, random, 200 + i), poses_at(0.1));
  EXPECT_EQ(averager.lines(), 9u);
  double square = 0.0;
  const LaserBeams& mean = averager.average_beams();
  for (std::size_t i = 0; i < mean.ranges_m.size(); ++i) {
    const double angle = mean.angle_min_rad + static_cast<double>(i) * mean.angle_increment_rad;
    const double error = mean.ranges_m[i] - kWall_m / (std::cos(0.1) * std::cos(angle));
    square += error * error / static_cast<double>(mean.ranges_m.size());
  }
  EXPECT_LT(std::sqrt(square), kNoise_m / 3.0 * 1.1);
}

TEST(DenseLines, AtAConstantTiltAddNothing) {
  std::mt19937 random(1);
  Modeler modeler(config());
  std::size_t added = 0;
  for (int i = 0; i < 500; ++i) {
    added +=
        modeler.add_scan_line(wall_line(i, 0.1, random), poses_at(0.1)) != LineResult::too_close;
  }
  EXPECT_LE(added, 1u);
  EXPECT_EQ(modeler.statistics().ribbons, 0u);
}

/// Expects that stamps must increase even among lines that are averaged.
TEST(DenseLines, MustHaveIncreasingStampsWithinAnAverage) {
  std::mt19937 random(1);
  Modeler modeler(config());
  for (const int index : {0, 1, 2})
    modeler.add_scan_line(wall_line(index, 0.1, random), poses_at(0.1));
  EXPECT_EQ(modeler.add_scan_line(wall_line(1, 0.1, random), poses_at(0.1)),
            LineResult::out_of_order);
}

}  // namespace
}  // namespace ribbon_mapper
