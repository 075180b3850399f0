// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/scan_line.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper {
namespace {

using mini_world::T_base_laser;

/// Returns the pose of a robot that turns at 0.6 rad/s and drives at 1 m/s.
Pose T_odom_base_at(double time_s) {
  return planar_pose(2.0 + time_s * 0.8, -1.0 + time_s * 0.6, 0.5 + 0.6 * time_s);
}

/// Returns the pose of a laser that tilts at 1 rad/s.
Pose T_base_laser_at(double time_s) { return T_base_laser(0.2 + time_s); }

constexpr double kScanTime_s = 0.0185;

/// Returns beams over 180 degrees with these ranges.
LaserBeams beams_with(std::vector<float> ranges_m) {
  LaserBeams beams;
  beams.stamp = from_seconds(5.0);
  beams.angle_min_rad = -M_PI_2;
  beams.angle_increment_rad = M_PI / 720.0;
  beams.time_increment_s = kScanTime_s / 720.0;
  beams.range_min_m = 0.1;
  beams.range_max_m = 30.0;
  beams.ranges_m = std::move(ranges_m);
  return beams;
}

/// Returns the poses of a line that is taken in motion.
LinePoses moving_poses() {
  return {T_odom_base_at(0.0), T_odom_base_at(kScanTime_s), T_base_laser_at(0.0),
          T_base_laser_at(kScanTime_s), planar_pose(7.0, 7.0, 1.0)};
}

ScanLine placed(const LaserBeams& beams, const LinePoses& poses, const ScanConfig& config = {}) {
  ScanLine line;
  place_beams(beams, poses, config, line);
  return line;
}

/// Returns the end of a beam from the pose of the laser at the time of the beam.
Eigen::Vector3d end_of_beam(const LaserBeams& beams, std::size_t i, const Pose& T_odom_laser) {
  const double angle = beams.angle_min_rad + i * beams.angle_increment_rad;
  return T_odom_laser *
         (beams.ranges_m[i] * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
}

TEST(PlaceBeams, UsesThePoseAtTheTimeOfEachBeam) {
  const LaserBeams beams = beams_with(std::vector<float>(721, 10.0F));
  const LinePoses poses = moving_poses();
  const ScanLine line = placed(beams, poses);
  const Pose first = poses.T_odom_base_first * poses.T_base_laser_first;
  const Pose last = poses.T_odom_base_last * poses.T_base_laser_last;
  for (std::size_t i = 0; i < 721; ++i) {
    const double fraction = i / 720.0, time_s = fraction * kScanTime_s;
    const Pose T_odom_laser = interpolate(first, last, fraction);
    EXPECT_LT((line.points[i] - end_of_beam(beams, i, T_odom_laser)).norm(), 5e-6);
    EXPECT_LT((line.origin(i) - T_odom_laser.translation()).norm(), 1e-12);
    EXPECT_NEAR(1.0, line.directions[i].norm(), 1e-6);
    // Base and tilt rotate about different axes, so the interpolation is not exact.
    const Pose T_odom_laser_true = T_odom_base_at(time_s) * T_base_laser_at(time_s);
    EXPECT_LT((line.points[i] - end_of_beam(beams, i, T_odom_laser_true)).norm(), 5e-4);
  }
}

TEST(PlaceBeams, SetsStampAndPosesOfTheMiddle) {
  const LinePoses poses = moving_poses();
  const ScanLine line = placed(beams_with(std::vector<float>(721, 10.0F)), poses);
  EXPECT_EQ(from_seconds(5.0 + 0.5 * kScanTime_s), line.stamp);
  EXPECT_TRUE(line.T_map_base.isApprox(poses.T_map_base));
  EXPECT_TRUE(line.T_odom_base.isApprox(T_odom_base_at(0.5 * kScanTime_s), 1e-6));
}

TEST(PlaceBeams, UsesTheMiddlePoseWithoutDeskew) {
  const LaserBeams beams = beams_with(std::vector<float>(721, 10.0F));
  ScanConfig config;
  config.deskew = false;
  const ScanLine line = placed(beams, moving_poses(), config);
  const Pose middle = T_odom_base_at(0.5 * kScanTime_s) * T_base_laser_at(0.5 * kScanTime_s);
  double max_m = 0.0;
  for (std::size_t i = 0; i < 721; ++i) {
    EXPECT_LT((line.points[i] - end_of_beam(beams, i, middle)).norm(), 5e-4);
    const double time_s = i / 720.0 * kScanTime_s;
    const Pose T_odom_laser = T_odom_base_at(time_s) * T_base_laser_at(time_s);
    max_m = std::max(max_m, (line.points[i] - end_of_beam(beams, i, T_odom_laser)).norm());
  }
  EXPECT_GT(max_m, 0.05);  // the effect of deskewing
}

TEST(PlaceBeams, AcceptsClockwiseLasers) {
  LaserBeams beams = beams_with(std::vector<float>(721, 10.0F));
  const LinePoses still{Pose::Identity(), Pose::Identity(), T_base_laser(0.3), T_base_laser(0.3),
                        Pose::Identity()};
  const ScanLine line = placed(beams, still);
  beams.angle_min_rad = M_PI_2;
  beams.angle_increment_rad *= -1.0;
  const ScanLine mirrored = placed(beams, still);
  for (std::size_t i = 0; i < 721; ++i) {
    EXPECT_LT((line.points[i] - mirrored.points[720 - i]).norm(), 1e-9);
  }
}

TEST(PlaceBeams, KeepsOnlyValidRanges) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const ScanLine line = placed(
      beams_with({2.0F, kNan, kInf, -kInf, -1.0F, 0.0F, 0.05F, 0.2F, 0.31F, 29.9F, 30.1F, 1e30F}),
      moving_poses());
  const std::vector<bool> expected{true,  false, false, false, false, false,
                                   false, false, true,  true,  false, false};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(expected[i], line.has_return(i)) << "beam " << i;
  }
  EXPECT_EQ(3.0, line.moments(0, 12).weight());
}

TEST(PlaceBeams, AppliesTheLimitsOfTheScan) {
  LaserBeams beams = beams_with({1.0F, 2.0F, 4.0F, 5.0F});
  beams.range_min_m = 1.5;
  beams.range_max_m = 4.0;
  const ScanLine line = placed(beams, moving_poses());
  EXPECT_FALSE(line.has_return(0));
  EXPECT_TRUE(line.has_return(1));
  EXPECT_TRUE(line.has_return(2));
  EXPECT_FALSE(line.has_return(3));
}

TEST(PlaceBeams, AppliesTheLimitsOfThePreset) {
  LaserBeams beams = beams_with({1.0F, 2.0F, 4.0F, 5.0F});
  beams.range_min_m = 0.1;
  beams.range_max_m = 60.0;
  ScanConfig config;
  config.body_half_size_m = 0.0;
  config.min_range_m = 1.5;
  config.max_range_m = 4.5;
  ScanLine line;
  place_beams(beams, moving_poses(), config, line);
  EXPECT_FALSE(line.has_return(0)) << "nearer than scan.min_range_m";
  EXPECT_TRUE(line.has_return(1));
  EXPECT_TRUE(line.has_return(2));
  EXPECT_FALSE(line.has_return(3)) << "further than scan.max_range_m";
}

TEST(PlaceBeams, AcceptsLinesOfNoneAndOneBeam) {
  EXPECT_EQ(0u, placed(beams_with({}), moving_poses()).size());
  const ScanLine line = placed(beams_with({3.0F}), moving_poses());
  ASSERT_EQ(1u, line.size());
  EXPECT_EQ(from_seconds(5.0), line.stamp);
  EXPECT_TRUE(line.has_return(0));
}

TEST(PlaceBeams, OverwritesTheFormerLine) {
  ScanLine line = placed(beams_with(std::vector<float>(721, 10.0F)), moving_poses());
  place_beams(beams_with(std::vector<float>(100, -1.0F)), moving_poses(), {}, line);
  EXPECT_EQ(100u, line.size());
  EXPECT_EQ(0.0, line.moments(0, 100).weight());
}

TEST(PlaceBeams, AccumulatesTheMomentsOfTheReturns) {
  std::vector<float> ranges_m;
  for (int i = 0; i < 200; ++i) ranges_m.push_back(i % 7 == 0 ? -1.0F : 3.0F + 0.01F * i);
  const ScanLine line = placed(beams_with(ranges_m), moving_poses());
  for (const auto& [begin, end] : {std::pair{0, 200}, {13, 14}, {14, 15}, {50, 170}}) {
    Moments slow;
    for (int i = begin; i < end; ++i) {
      if (i % 7 != 0) slow.add(line.points[i]);
    }
    const Moments fast = line.moments(begin, end);
    ASSERT_NEAR(slow.weight(), fast.weight(), 1e-9);
    if (slow.weight() == 0.0) continue;
    EXPECT_LT((slow.mean() - fast.mean()).norm(), 1e-11);
    EXPECT_LT((slow.covariance() - fast.covariance()).norm(), 1e-10);
  }
}

/// Expects that each beam belongs to its segment [begin, end).
void expect_segments(const std::vector<std::pair<unsigned, unsigned>>& expected,
                     const std::vector<float>& ranges_m) {
  const ScanLine line = placed(beams_with(ranges_m), moving_poses());
  for (const auto& [begin, end] : expected) {
    for (unsigned i = begin; i < end; ++i) {
      EXPECT_EQ(begin, line.first_of_segment[i]) << "beam " << i;
      EXPECT_EQ(end, line.end_of_segment[i]) << "beam " << i;
    }
  }
}

TEST(Segments, EndAtJumpsInDepth) {
  std::vector<float> ranges_m(60, 3.0F);
  for (int i = 20; i < 40; ++i) ranges_m[i] = 3.3F;
  expect_segments({{0, 20}, {20, 40}, {40, 60}}, ranges_m);
}

TEST(Segments, EndAtMissingReturns) {
  std::vector<float> ranges_m(60, 3.0F);
  ranges_m[30] = std::numeric_limits<float>::infinity();
  expect_segments({{0, 30}, {30, 31}, {31, 60}}, ranges_m);
}

TEST(Segments, AreNotSplitByNoise) {
  std::vector<float> ranges_m;
  for (int i = 0; i < 60; ++i)
    ranges_m.push_back(i % 2 ? 3.04F : 2.96F);  // two standard deviations either way
  expect_segments({{0, 60}}, ranges_m);
}

TEST(Segments, AreNotSplitOnAWallSeenAtAGrazingAngle) {
  std::vector<float> ranges_m;  // a wall 1 m to the right, seen under down to 10 degrees
  for (int i = 0; i <= 4 * 80; ++i) {
    ranges_m.push_back(static_cast<float>(1.0 / std::cos(i * M_PI / 720.0)));
  }
  expect_segments({{0, static_cast<unsigned>(ranges_m.size())}}, ranges_m);
}

}  // namespace
}  // namespace ribbon_mapper
