// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/trajectory_error.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper::eval {
namespace {

/// Poses along an L, a metre apart.
std::vector<StampedPose> corner() {
  std::vector<StampedPose> poses;
  for (int i = 0; i < 4; ++i) poses.push_back({Time(i), planar_pose(i, 0.0, 0.0)});
  for (int i = 1; i < 4; ++i) poses.push_back({Time(3 + i), planar_pose(3.0, i, M_PI / 2.0)});
  return poses;
}

std::vector<StampedPose> moved_by(const Pose& motion, std::vector<StampedPose> poses) {
  for (StampedPose& pose : poses) pose.T_map_base = motion * pose.T_map_base;
  return poses;
}

TEST(TrajectoryError, OfTheTruthIsZero) {
  const TrajectoryError error = trajectory_error(corner(), corner());
  EXPECT_EQ(error.rmse_m, 0.0);
  EXPECT_EQ(error.largest_m, 0.0);
  EXPECT_NEAR(error.rmse_deg, 0.0, 1e-6);
  EXPECT_NEAR(error.aligned_rmse_m, 0.0, 1e-12);
}

TEST(TrajectoryError, OfAShiftVanishesWhenAligned) {
  const auto shifted = moved_by(planar_pose(0.3, 0.4, 0.0), corner());
  const TrajectoryError error = trajectory_error(shifted, corner());
  EXPECT_NEAR(error.rmse_m, 0.5, 1e-12);
  EXPECT_NEAR(error.largest_m, 0.5, 1e-12);
  EXPECT_NEAR(error.rmse_deg, 0.0, 1e-6);
  EXPECT_NEAR(error.aligned_rmse_m, 0.0, 1e-12);
}

TEST(TrajectoryError, OfATurnIsSeenAsAnAngle) {
  const auto turned = moved_by(planar_pose(0.0, 0.0, 2.0 * kDegree), corner());
  const TrajectoryError error = trajectory_error(turned, corner());
  EXPECT_NEAR(error.rmse_deg, 2.0, 1e-9);
  EXPECT_NEAR(error.largest_m, 2.0 * std::sin(kDegree) * std::hypot(3.0, 3.0), 1e-9);
  EXPECT_NEAR(error.aligned_rmse_m, 0.0, 1e-12);
}

TEST(TrajectoryError, OfASinglePoseIsRootMeanSquare) {
  auto estimate = corner();
  estimate[2].T_map_base.translation().z() += 0.7;
  const TrajectoryError error = trajectory_error(estimate, corner());
  EXPECT_NEAR(error.rmse_m, 0.7 / std::sqrt(7.0), 1e-12);
  EXPECT_NEAR(error.largest_m, 0.7, 1e-12);
  EXPECT_GT(error.aligned_rmse_m, 0.1);
  EXPECT_LT(error.aligned_rmse_m, error.rmse_m);
}

TEST(TrajectoryError, NeedsPosesOfBoth) {
  EXPECT_THROW(trajectory_error({}, {}), std::invalid_argument);
  EXPECT_THROW(trajectory_error(corner(), {}), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper::eval
