// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/pose_belief.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

using hall::any_covariance, hall::any_pose, hall::difference, hall::random_matrix;

Vector6 vector6(double x, double y, double z, double roll, double pitch, double yaw) {
  Vector6 result;
  result << x, y, z, roll, pitch, yaw;
  return result;
}

double difference(const Matrix6& a, const Matrix6& b) { return (a - b).cwiseAbs().maxCoeff(); }

TEST(PoseError, MovesTheOriginAndTurnsAboutItAlongTheModelsAxes) {
  const Pose pose = planar_pose(1.0, 2.0, M_PI / 2.0);
  const Pose result = moved(pose, vector6(0.1, 0.2, 0.3, 0.0, M_PI / 2.0, 0.0));
  EXPECT_LT((result.translation() - Eigen::Vector3d(1.1, 2.2, 0.3)).norm(), 1e-12);
  // The base's x-axis points along the model's y, the axis of the turn, and stays.
  EXPECT_LT((result.linear().col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((result.linear().col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(PoseError, OfZeroLeavesThePose) {
  EXPECT_LT(difference(any_pose(1), moved(any_pose(1), Vector6::Zero())), 1e-15);
  EXPECT_LT(error_between(any_pose(1), any_pose(1)).norm(), 1e-12);
}

TEST(PoseError, IsFoundAgainBetweenThePoses) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    for (const double size : {1e-9, 1e-3, 0.1, 1.5}) {
      const Vector6 error = size * random_matrix(6, 1, seed);
      const Vector6 found = error_between(any_pose(seed), moved(any_pose(seed), error));
      EXPECT_LT((error - found).norm(), 1e-12) << seed << ", " << size;
    }
    const Vector6 between = error_between(any_pose(seed), any_pose(seed + 1));
    EXPECT_LT(difference(any_pose(seed + 1), moved(any_pose(seed), between)), 1e-12);
  }
}

TEST(Transport, IsTheJacobianOfACarriedFrame) {
  const Pose base = any_pose(4), T_base_point = any_pose(5);
  const Pose point = base * T_base_point;
  const Eigen::MatrixXd expected = hall::derivative_by_error(
      [&](const Vector6& e) { return error_between(point, moved(base, e) * T_base_point); }, 6);
  EXPECT_LT(difference(expected, transport(point.translation() - base.translation())), 1e-8);
}

TEST(InModelAxes, TurnsBothBlocks) {
  const Vector6 on_axes = vector6(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
  const Matrix6 turned = in_model_axes(on_axes, planar_pose(0.0, 0.0, M_PI / 2.0).linear());
  Matrix6 expected = Matrix6::Zero();
  expected.diagonal() << 2.0, 1.0, 3.0, 5.0, 4.0, 6.0;
  EXPECT_LT(difference(expected, turned), 1e-12);

  Matrix6 rotations = Matrix6::Zero();
  rotations.topLeftCorner<3, 3>() = any_pose(6).linear();
  rotations.bottomRightCorner<3, 3>() = any_pose(6).linear();
  EXPECT_LT(difference(rotations * on_axes.asDiagonal() * rotations.transpose(),
                       in_model_axes(on_axes, any_pose(6).linear())),
            1e-12);
}

/// A covariance pushed through a Jacobian.
Matrix6 pushed(const Matrix6& jacobian, const Matrix6& covariance) {
  return jacobian * covariance * jacobian.transpose();
}

TEST(Step, ForwardPropagatesTheErrorsOfPoseAndStep) {
  const PoseBelief from{any_pose(7), any_covariance(0.1, 7)};
  const Pose step = any_pose(8);
  const Vector6 variances = vector6(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  const PoseBelief to = after_step(from, step, variances);
  EXPECT_LT(difference(from.T_model_base * step, to.T_model_base), 1e-12);

  const auto error_after = [&](const Vector6& e) {
    return error_between(to.T_model_base, moved(from.T_model_base, e) * step);
  };
  const Matrix6 by_pose = hall::derivative_by_error(error_after, 6);
  const Matrix6 noise = in_model_axes(variances, from.T_model_base.linear());
  EXPECT_LT(difference(pushed(by_pose, from.covariance) + noise, to.covariance), 1e-7);
}

TEST(Step, ForwardTakesACovarianceAlongTheSameAxes) {
  const PoseBelief from{any_pose(7), any_covariance(0.1, 7)};
  const Vector6 variances = vector6(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  const PoseBelief to = after_step(from, any_pose(8), variances);
  const Matrix6 correlated = any_covariance(0.1, 9);
  const Matrix6 added = after_step(from, any_pose(8), correlated).covariance - to.covariance;
  const Eigen::Matrix3d rotation = from.T_model_base.linear();
  EXPECT_LT(
      difference(in_other_axes(correlated, rotation) - in_model_axes(variances, rotation), added),
      1e-12);
}

TEST(Step, BackwardPropagatesTheErrorsOfPoseAndStep) {
  const PoseBelief to{any_pose(9), any_covariance(0.1, 9)};
  const Pose step = any_pose(10);
  const Vector6 variances = vector6(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  const PoseBelief from = before_step(to, step, variances);
  EXPECT_LT(difference(to.T_model_base, from.T_model_base * step), 1e-12);

  const auto error_before = [&](const Vector6& e) {
    return error_between(from.T_model_base, moved(to.T_model_base, e) * step.inverse());
  };
  const Matrix6 by_pose = hall::derivative_by_error(error_before, 6);
  const Matrix6 noise = in_model_axes(variances, from.T_model_base.linear());
  EXPECT_LT(difference(pushed(by_pose, to.covariance + noise), from.covariance), 1e-7);
}

TEST(Step, ThereAndBackIsTheSameBeliefIfTheStepIsExact) {
  const PoseBelief belief{any_pose(11), any_covariance(0.1, 11)};
  const Vector6 exact = Vector6::Zero();
  const PoseBelief back = before_step(after_step(belief, any_pose(12), exact), any_pose(12), exact);
  EXPECT_LT(difference(belief.T_model_base, back.T_model_base), 1e-12);
  EXPECT_LT(difference(belief.covariance, back.covariance), 1e-12);
}

TEST(Fusion, IsTheProductOfTheGaussians) {
  const PoseBelief a{any_pose(13), any_covariance(0.01, 13)};
  const PoseBelief b{moved(a.T_model_base, 0.001 * random_matrix(6, 1, 14)),
                     any_covariance(0.02, 14)};
  const Matrix6 information_a = a.covariance.inverse(), information_b = b.covariance.inverse();
  const Matrix6 covariance = (information_a + information_b).inverse();
  const Vector6 mean = covariance * information_b * error_between(a.T_model_base, b.T_model_base);
  const PoseBelief both = fused(a, b);
  EXPECT_LT(difference(covariance, both.covariance), 1e-9 * covariance.norm());
  EXPECT_LT((mean - error_between(a.T_model_base, both.T_model_base)).norm(), 1e-10);

  const PoseBelief exchanged = fused(b, a);
  EXPECT_LT(difference(exchanged.T_model_base, both.T_model_base), 1e-6);
  EXPECT_LT(difference(exchanged.covariance, both.covariance), 1e-10);
  EXPECT_EQ(both.covariance, both.covariance.transpose());
}

TEST(Fusion, ACertainBeliefWins) {
  const PoseBelief certain{any_pose(15), Matrix6::Zero()};
  const PoseBelief vague{moved(certain.T_model_base, 0.1 * random_matrix(6, 1, 16)),
                         any_covariance(0.1, 16)};
  for (const PoseBelief& both : {fused(certain, vague), fused(vague, certain)}) {
    EXPECT_LT(difference(certain.T_model_base, both.T_model_base), 1e-12);
    EXPECT_LT(both.covariance.norm(), 1e-12);
  }
}

/// Measurements of full rank, linearised somewhere else than at the belief's mean.
PoseInformation measurement(const PoseBelief& belief) {
  PoseInformation measured;
  measured.T_model_base = moved(belief.T_model_base, 0.002 * random_matrix(6, 1, 18));
  measured.matrix = any_covariance(0.03, 19).inverse();
  measured.vector = measured.matrix * (0.003 * random_matrix(6, 1, 20));
  return measured;
}

TEST(Update, SolvesTheNormalEquations) {
  const PoseBelief belief{any_pose(17), any_covariance(0.02, 17)};
  const PoseInformation measured = measurement(belief);
  const Matrix6 prior = belief.covariance.inverse();
  const Matrix6 covariance = (prior + measured.matrix).inverse();
  const Vector6 error =
      covariance *
      (prior * error_between(measured.T_model_base, belief.T_model_base) + measured.vector);
  const PoseBelief result = updated(belief, measured);
  EXPECT_LT(difference(covariance, result.covariance), 1e-9 * covariance.norm());
  EXPECT_LT((error - error_between(measured.T_model_base, result.T_model_base)).norm(), 1e-10);
  EXPECT_EQ(result.covariance, result.covariance.transpose());
}

TEST(Update, NothingMeasuredChangesNothing) {
  const PoseBelief belief{any_pose(17), any_covariance(0.02, 17)};
  PoseInformation nothing;
  nothing.T_model_base = measurement(belief).T_model_base;
  const PoseBelief result = updated(belief, nothing);
  EXPECT_LT(difference(belief.T_model_base, result.T_model_base), 1e-12);
  EXPECT_LT(difference(belief.covariance, result.covariance), 1e-15);
}

TEST(Update, ACertainBeliefIsNotMoved) {
  const PoseBelief certain{any_pose(17), Matrix6::Zero()};
  const PoseBelief result = updated(certain, measurement(certain));
  EXPECT_LT(difference(certain.T_model_base, result.T_model_base), 1e-12);
  EXPECT_EQ(Matrix6::Zero(), result.covariance);
}

TEST(Update, OfOneDirectionLeavesTheOthers) {
  const PoseBelief belief{any_pose(21), 0.04 * Matrix6::Identity()};
  PoseInformation of_x;
  of_x.T_model_base = belief.T_model_base;
  of_x.matrix(0, 0) = 75.0;  // sigma^-2, with the prior's 25 that is 100
  of_x.vector[0] = 75.0 * 0.1;
  const PoseBelief result = updated(belief, of_x);
  const Vector6 error = error_between(belief.T_model_base, result.T_model_base);
  EXPECT_NEAR(0.075, error[0], 1e-12);
  EXPECT_LT(error.tail<5>().norm(), 1e-12);
  EXPECT_NEAR(0.01, result.covariance(0, 0), 1e-12);
  EXPECT_NEAR(0.04, result.covariance(1, 1), 1e-12);
}

TEST(PoseBelief, CovariancesTurnWithTheAxes) {
  const Vector6 on_axes = (Vector6() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0).finished();
  const Eigen::Matrix3d first = any_pose(3).linear(), second = any_pose(4).linear();
  EXPECT_TRUE(in_other_axes(in_model_axes(on_axes, first), second)
                  .isApprox(in_model_axes(on_axes, second * first), 1e-12));
}

}  // namespace
}  // namespace ribbon_mapper
