// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/level_scan.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "test/slam/matching/wall_world.hpp"

namespace ribbon_mapper::slam {
namespace {

/// Returns the distance of a point from the nearest wall of WallWorld::square().
double off_the_square(const LevelPoint& p) {
  return std::abs(std::max(std::abs(p.x_m), std::abs(p.y_m)) - 3.0);
}

TEST(LevelScan, PointsLieOnTheWallsAndNormalsFaceTheLaser) {
  const LevelScan scan = WallWorld::square().scan({}, 1.0, true);
  ASSERT_GT(scan.points.size(), 100U);
  std::size_t with_normal = 0;
  for (const LevelPoint& p : scan.points) {
    EXPECT_LT(off_the_square(p), 1e-5);
    if (p.normal_x == 0.0F && p.normal_y == 0.0F) continue;
    ++with_normal;
    EXPECT_LT(p.normal_x * p.x_m + p.normal_y * p.y_m, 0.0F);
  }
  EXPECT_GT(with_normal, scan.points.size() * 8 / 10);
}

TEST(LevelScan, BeamsWithoutAReturnAreLeftOut) {
  LaserBeams beams = WallWorld::square().beams({});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  beams.ranges_m = {nan, infinite, -infinite, 0.0F, -1.0F, 1e30F, 2.0F};
  const LevelScan scan = level_scan_of(beams, Pose::Identity(), {}, LevelScanConfig());
  ASSERT_EQ(scan.points.size(), 1U);
  EXPECT_NEAR(std::hypot(scan.points[0].x_m, scan.points[0].y_m), 2.0, 1e-6);
}

TEST(LevelScan, ALaserThatHangsUpsideDownSeesTheSame) {
  const Pose T_base_laser =
      planar_pose(0.2, 0.1, 0.3) * Pose(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(is_level(T_base_laser, LevelScanConfig()));
  LaserBeams beams = WallWorld::square().beams({0.2, 0.1, 0.3});
  beams.angle_min_rad = -beams.angle_min_rad;
  beams.angle_increment_rad = -beams.angle_increment_rad;
  for (const LevelPoint& p : level_scan_of(beams, T_base_laser, {}, LevelScanConfig()).points)
    EXPECT_LT(off_the_square(p), 1e-5);
}

TEST(LevelScan, AnInclinedLaserIsNotLevel) {
  const Pose tilted(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  EXPECT_FALSE(is_level(tilted, LevelScanConfig()));
}

TEST(LevelScan, BeamsOfAMovingRobotAreSeenFromItsFirstPose) {
  // the robot turns by 0.2 rad and drives 0.1 m during the rotation
  const PlanarPose T_first_last{0.1, 0.0, 0.2};
  LaserBeams beams = WallWorld::square().beams({});
  const double last = static_cast<double>(beams.ranges_m.size()) - 1.0;
  for (std::size_t i = 0; i < beams.ranges_m.size(); ++i) {
    const double part = static_cast<double>(i) / last;
    const double angle = part * T_first_last.yaw_rad + beams.angle_min_rad +
                         static_cast<double>(i) * beams.angle_increment_rad;
    beams.ranges_m[i] =
        static_cast<float>(WallWorld::square().range_m(part * T_first_last.x_m, 0.0, angle));
  }
  for (const LevelPoint& p : level_scan_of(beams, Pose::Identity(), T_first_last, {}).points)
    EXPECT_LT(off_the_square(p), 1e-5);
}

/// Returns the mean of y minus that of the wall, over points up to 2 m ahead of scans with 1 cm of
/// noise along a corridor [m].
double mean_off_the_wall_m(const WallWorld& corridor, int scans) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0F, 0.01F);
  double sum = 0.0, count = 0.0;
  for (int i = 0; i < scans; ++i) {
    LaserBeams beams = corridor.beams({});
    for (float& range : beams.ranges_m) range += noise(random);
    for (const LevelPoint& p : level_scan_of(beams, Pose::Identity(), {}, {}).points) {
      if (p.x_m > 2.0F) continue;
      sum += p.y_m - (p.y_m > 0.0F ? 1.0 : -1.0), count += 1.0;
    }
  }
  return sum / count;
}

TEST(LevelScan, TheNoiseOfRangesDoesNotChooseThePoints) {
  // Points that were chosen for their distance would lie to the right on both walls: the sweep goes
  // outwards on one and inwards on the other. 1 cm over some 20,000 points leaves 0.1 mm.
  EXPECT_NEAR(mean_off_the_wall_m(WallWorld::corridor(), 500), 0.0, 4e-4);
}

}  // namespace
}  // namespace ribbon_mapper::slam
