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

/// One covariance for each pose of corner(), with these variances of x, y and heading.
std::vector<Matrix6> covariances(double x, double y, double heading) {
  Matrix6 covariance = Matrix6::Identity();
  covariance(0, 0) = x, covariance(1, 1) = y, covariance(5, 5) = heading;
  return std::vector<Matrix6>(corner().size(), covariance);
}

TEST(Nees, IsOneWhereErrorsAreAsLargeAsStated) {
  auto estimate = corner();
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    estimate[i].T_map_base.translation() += Eigen::Vector3d(0.3, -0.4, 100.0);  // z does not count
    estimate[i].T_map_base.linear() =
        planar_pose(0.0, 0.0, 0.1).linear() * estimate[i].T_map_base.linear();
  }
  EXPECT_NEAR(planar_nees(estimate, covariances(0.09, 0.16, 0.01), corner()), 1.0, 1e-9);
  EXPECT_NEAR(planar_nees(estimate, covariances(0.36, 0.64, 0.04), corner()), 0.25, 1e-9);
}

TEST(Nees, IsMeasuredFromTheFirstPose) {
  const auto turned = moved_by(planar_pose(3.0, 1.0, 0.5), corner());
  EXPECT_NEAR(planar_nees(turned, covariances(0.01, 0.01, 0.01), corner()), 0.0, 1e-12);
}

TEST(Nees, NeedsACovarianceForEachPose) {
  EXPECT_THROW(planar_nees(corner(), {}, corner()), std::invalid_argument);
  EXPECT_THROW(planar_nees({corner()[0]}, {Matrix6::Identity()}, {corner()[0]}),
               std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper::eval
