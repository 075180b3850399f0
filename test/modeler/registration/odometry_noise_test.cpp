// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/odometry_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ribbon_mapper {
namespace {

/// 60 ways of 40 steps to and fro, of which the odometry errs by `planar` and `spatial` times what
/// its motion model says.
std::vector<OdometryCheck> random_walks(double planar, double spatial) {
  OdometryNoise noise;
  noise.planar = planar, noise.spatial = spatial;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<OdometryCheck> checks;
  for (int i = 0; i < 60; ++i) {
    OdometryCheck check;
    for (int k = 0; k < 40; ++k) {
      const Pose step = planar_pose(0.02, 0.0, i % 2 == 0 ? 0.02 : -0.01);
      Vector6 error = noise.variances(step).cwiseSqrt();
      for (double& e : error) e *= normal(random);
      check.steps.push_back(step);
      check.T_first_last_true = moved(check.T_first_last_true * step, error);
    }
    checks.push_back(check);
  }
  return checks;
}

TEST(OdometryNoise, IsThatOfGmappingsMotionModelAtItsReferenceStep) {
  const Vector6 drive = OdometryNoise{}.variances(planar_pose(0.5, 0.0, 0.0));
  EXPECT_NEAR(0.005, std::sqrt(drive[0]), 1e-5);  // srr * 0.5 m
  EXPECT_NEAR(0.01, std::sqrt(drive[5]), 1e-5);   // srt * 0.5 m
  const Vector6 turn = OdometryNoise{}.variances(planar_pose(0.0, 0.0, 0.436));
  EXPECT_NEAR(0.00436, std::sqrt(turn[0]), 1e-5);  // str * 0.436 rad
  EXPECT_NEAR(0.00872, std::sqrt(turn[5]), 1e-5);  // stt * 0.436 rad
}

TEST(OdometryNoise, TheErrorDoesNotDependOnHowFinelyTheWayIsCut) {
  const OdometryNoise noise;
  const Vector6 whole = noise.variances(planar_pose(0.4, 0.0, 0.0));
  const Vector6 tenth = noise.variances(planar_pose(0.04, 0.0, 0.0));
  EXPECT_LT((whole - 10.0 * tenth).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(OdometryNoise, ItsScaleIsFoundFromWhatItShows) {
  const OdometryNoise found = fitted_to(random_walks(3.0, 0.2));
  EXPECT_NEAR(3.0, found.planar, 0.5);
  EXPECT_NEAR(0.2, found.spatial, 0.04);
}

TEST(OdometryNoise, ARobotThatNeverLeavesThePlaneIsTakenToStayThere) {
  const OdometryNoise found = fitted_to(random_walks(1.0, 0.0));
  EXPECT_NEAR(1.0, found.planar, 0.2);
  EXPECT_LE(found.spatial, 0.011);
}

}  // namespace
}  // namespace ribbon_mapper
