// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/pose_belief.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace ribbon_mapper {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Covariance once the base is `lever` (in world) further on, on the same rigid body.
Matrix6 carried(const Matrix6& covariance, const Eigen::Vector3d& lever) {
  Matrix6 carry = Matrix6::Identity();
  carry.topRightCorner<3, 3>() = -cross_matrix(lever);
  return carry * covariance * carry.transpose();
}

Matrix6 in_world(const Vector6& variances, const Eigen::Matrix3d& rotation) {
  Matrix6 covariance = Matrix6::Zero();
  covariance.topLeftCorner<3, 3>() =
      rotation * variances.head<3>().asDiagonal() * rotation.transpose();
  covariance.bottomRightCorner<3, 3>() =
      rotation * variances.tail<3>().asDiagonal() * rotation.transpose();
  return covariance;
}

Matrix6 symmetric(const Matrix6& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

Pose moved(const Pose& T_world_base, const Vector6& error) {
  Pose result = T_world_base;
  const double angle = error.tail<3>().norm();
  if (angle > 0.0) {
    const Eigen::AngleAxisd turn(angle, error.tail<3>() / angle);
    result.linear() = (turn * Eigen::Quaterniond(T_world_base.linear())).normalized()
                          .toRotationMatrix();
  }
  result.translation() += error.head<3>();
  return result;
}

Vector6 error_between(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(
      Eigen::Quaterniond(Eigen::Matrix3d(to.linear() * from.linear().transpose())));
  Vector6 error;
  error << to.translation() - from.translation(), turn.angle() * turn.axis();
  return error;
}

PoseBelief after_step(const PoseBelief& from, const Pose& step, const Vector6& variances) {
  const Eigen::Matrix3d rotation = from.T_world_base.linear();
  const Eigen::Vector3d lever = rotation * step.translation();
  return {from.T_world_base * step,
          carried(from.covariance, lever) + in_world(variances, rotation)};
}

PoseBelief before_step(const PoseBelief& to, const Pose& step, const Vector6& variances) {
  const Pose T_world_base = to.T_world_base * step.inverse(Eigen::Isometry);
  const Eigen::Matrix3d rotation = T_world_base.linear();
  const Eigen::Vector3d lever = -(rotation * step.translation());
  return {T_world_base, carried(to.covariance + in_world(variances, rotation), lever)};
}

PoseBelief fused(const PoseBelief& a, const PoseBelief& b) {
  const Matrix6 gain =
      (a.covariance + b.covariance).ldlt().solve(a.covariance).transpose();
  const Vector6 error = gain * error_between(a.T_world_base, b.T_world_base);
  return {moved(a.T_world_base, error),
          symmetric(a.covariance - gain * a.covariance)};
}

PoseBelief updated(const PoseBelief& belief, const Observation& observation) {
  const Vector6 error = error_between(observation.T_world_base, belief.T_world_base);
  const Eigen::PartialPivLU<Matrix6> lu(Matrix6::Identity() +
                                        belief.covariance * observation.information);
  const Vector6 solution = lu.solve(error + belief.covariance * observation.gradient);
  return {moved(observation.T_world_base, solution), symmetric(lu.solve(belief.covariance))};
}

}  // namespace ribbon_mapper
