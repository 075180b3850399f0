// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/robot/pr2.hpp"

#include <gtest/gtest.h>

namespace ribbon_mapper::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Translation3d;
using Eigen::Vector3d;

/// Composes the joints of pr2_description one by one.
Pose chain(double tilt_rad, double torso_m) {
  return Translation3d(0, 0, 0.051) *                   // base_footprint_joint
         Translation3d(-0.05, 0, 0.739675 + torso_m) *  // torso_lift_joint
         Translation3d(0.09893, 0, 0.227) *             // laser_tilt_mount_joint
         AngleAxisd(tilt_rad, Vector3d::UnitY()) * Translation3d(0, 0, 0.03) *
         Pose::Identity();  // laser_tilt_joint
}

TEST(Pr2, LaserIsWhereTheJointsPutIt) {
  for (const double torso_m : {0.0, 0.0115, 0.33})
    for (double tilt_rad = -0.7854; tilt_rad <= 1.48353; tilt_rad += 0.05)
      EXPECT_TRUE(pr2::T_base_laser(tilt_rad, torso_m).isApprox(chain(tilt_rad, torso_m), 1e-12));
}

TEST(Pr2, LaserHeightOfTheDescription) {
  const Vector3d level = pr2::T_base_laser(0.0, 0.0).translation();
  EXPECT_TRUE(level.isApprox(Vector3d(0.04893, 0.0, 1.047675), 1e-9)) << level.transpose();
  EXPECT_NEAR(pr2::T_base_laser(0.0).translation().z(), 1.047675 + 0.0115, 1e-9)
      << "the torso rests at its lower soft stop";
}

TEST(Pr2, LaserInMapIsTheProduct) {
  for (const double yaw_rad : {-2.0, 0.0, 0.7})
    for (const double tilt_rad : {-0.5, 0.0, 1.0}) {
      const Pose T_map_base = planar_pose(1.0, -2.0, yaw_rad);
      EXPECT_TRUE(pr2::T_map_laser(T_map_base, tilt_rad)
                      .isApprox(T_map_base * chain(tilt_rad, 0.0115), 1e-12));
    }
}

TEST(Pr2, BaseLaserIsLevelWhereTheJointsPutIt) {
  const Pose joints = Pose(Translation3d(0, 0, 0.051) * Translation3d(0.275, 0, 0.252));
  EXPECT_TRUE(pr2::T_base_base_laser().isApprox(joints, 1e-12));
}

TEST(Pr2, PositiveTiltLooksDown) {
  EXPECT_LT(pr2::T_base_laser(0.5).linear().col(0).z(), 0.0);
  EXPECT_GT(pr2::T_base_laser(0.5).translation().x(), 0.04893) << "the lever turns with it";
}

TEST(Pr2, BodyStandsOnTheGroundAroundTheBase) {
  const Pose T_map_body = pr2::T_map_body(planar_pose(3.0, 1.0, 0.4));
  EXPECT_NEAR(T_map_body.translation().z() - pr2::kBodySize_m.z() / 2.0, pr2::kBodyBottom_m, 1e-12);
  EXPECT_NEAR(T_map_body.translation().x(), 3.0, 1e-12);
  EXPECT_NEAR(yaw_of(T_map_body), 0.4, 1e-12);
}

}  // namespace
}  // namespace ribbon_mapper::sim
