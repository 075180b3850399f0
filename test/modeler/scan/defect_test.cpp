// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Returns beams without a defect.
LaserBeams good_beams() {
  LaserBeams beams;
  beams.angle_min_rad = -M_PI;
  beams.angle_increment_rad = M_PI / 360.0;
  beams.time_increment_s = 1e-5;
  beams.range_min_m = 0.0;
  beams.range_max_m = 30.0;
  beams.ranges_m.assign(721, 1.0F);
  return beams;
}

TEST(FindDefect, AcceptsGoodLines) {
  EXPECT_FALSE(find_defect(good_beams(), {}));
  LaserBeams beams = good_beams();
  beams.angle_increment_rad *= -1.0;  // clockwise
  EXPECT_FALSE(find_defect(beams, {}));
  beams = good_beams();
  beams.range_max_m = kInf;
  EXPECT_FALSE(find_defect(beams, {}));
  beams.ranges_m.clear();  // no returns are no defect
  EXPECT_FALSE(find_defect(beams, {}));
  beams = good_beams();
  beams.time_increment_s = 0.0;  // all beams at the same time
  EXPECT_FALSE(find_defect(beams, {}));
}

TEST(FindDefect, FindsEachBadField) {
  const std::vector<std::function<void(LaserBeams&)>> defects{
      [](LaserBeams& b) { b.angle_min_rad = kNan; },
      [](LaserBeams& b) { b.angle_min_rad = kInf; },
      [](LaserBeams& b) { b.angle_increment_rad = kNan; },
      [](LaserBeams& b) { b.angle_increment_rad = -kInf; },
      [](LaserBeams& b) { b.angle_increment_rad = 0.0; },
      [](LaserBeams& b) { b.time_increment_s = kNan; },
      [](LaserBeams& b) { b.time_increment_s = kInf; },
      [](LaserBeams& b) { b.range_min_m = kNan; },
      [](LaserBeams& b) { b.range_min_m = -0.1; },
      [](LaserBeams& b) { b.range_max_m = kNan; },
      [](LaserBeams& b) { b.range_max_m = 0.0; },
      [](LaserBeams& b) { b.ranges_m.resize(800); }};
  for (std::size_t i = 0; i < defects.size(); ++i) {
    LaserBeams beams = good_beams();
    defects[i](beams);
    EXPECT_TRUE(find_defect(beams, {})) << "defect " << i;
  }
}

TEST(FindDefect, FindsEachBadPose) {
  for (Pose LinePoses::*pose :
       {&LinePoses::T_odom_base_first, &LinePoses::T_odom_base_last, &LinePoses::T_base_laser_first,
        &LinePoses::T_base_laser_last, &LinePoses::T_map_base}) {
    LinePoses poses;
    (poses.*pose).translation().x() = kNan;
    EXPECT_TRUE(find_defect(good_beams(), poses));
    poses = {};
    (poses.*pose).linear().setZero();  // a quaternion of zeros
    EXPECT_TRUE(find_defect(good_beams(), poses));
    poses = {};
    (poses.*pose).translation().y() = -1e19;
    EXPECT_EQ("a pose lies more than 1e9 m from the origin", find_defect(good_beams(), poses));
  }
}

TEST(FindDefect, FindsAJumpOfOdometryWithinALine) {
  LinePoses poses;
  poses.T_odom_base_first = poses.T_odom_base_last = planar_pose(5e5, 5.3e6, 0.0);
  EXPECT_FALSE(find_defect(good_beams(), poses));
  poses.T_odom_base_first = Pose::Identity();
  EXPECT_EQ("odometry jumps by more than 100 m within the line", find_defect(good_beams(), poses));
}

}  // namespace
}  // namespace ribbon_mapper
