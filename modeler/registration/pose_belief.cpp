// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/pose_belief.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace ribbon_mapper {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Matrix6 symmetric(const Matrix6& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

Pose moved(const Pose& T_model_base, const Vector6& error) {
  Pose result = T_model_base;
  const double angle = error.tail<3>().norm();
  if (angle > 0.0) {
    const Eigen::AngleAxisd turn(angle, error.tail<3>() / angle);
    result.linear() =
        (turn * Eigen::Quaterniond(T_model_base.linear())).normalized().toRotationMatrix();
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

Matrix6 carry(const Eigen::Vector3d& lever) {
  Matrix6 result = Matrix6::Identity();
  result.topRightCorner<3, 3>() = -cross_matrix(lever);
  return result;
}

Matrix6 in_world(const Vector6& on_axes, const Eigen::Matrix3d& rotation) {
  Matrix6 result = Matrix6::Zero();
  result.topLeftCorner<3, 3>() = rotation * on_axes.head<3>().asDiagonal() * rotation.transpose();
  result.bottomRightCorner<3, 3>() =
      rotation * on_axes.tail<3>().asDiagonal() * rotation.transpose();
  return result;
}

PoseBelief after_step(const PoseBelief& from, const Pose& step, const Vector6& variances) {
  const Eigen::Matrix3d rotation = from.T_model_base.linear();
  const Matrix6 carried = carry(rotation * step.translation());
  return {from.T_model_base * step,
          carried * from.covariance * carried.transpose() + in_world(variances, rotation)};
}

PoseBelief before_step(const PoseBelief& to, const Pose& step, const Vector6& variances) {
  const Pose T_model_base = to.T_model_base * step.inverse(Eigen::Isometry);
  const Eigen::Matrix3d rotation = T_model_base.linear();
  const Matrix6 carried = carry(-(rotation * step.translation()));
  return {T_model_base,
          carried * (to.covariance + in_world(variances, rotation)) * carried.transpose()};
}

PoseBelief fused(const PoseBelief& a, const PoseBelief& b) {
  const Matrix6 gain = (a.covariance + b.covariance).ldlt().solve(a.covariance).transpose();
  const Vector6 error = gain * error_between(a.T_model_base, b.T_model_base);
  return {moved(a.T_model_base, error), symmetric(a.covariance - gain * a.covariance)};
}

PoseBelief updated(const PoseBelief& belief, const Observation& observation) {
  const Vector6 error = error_between(observation.T_model_base, belief.T_model_base);
  const Eigen::PartialPivLU<Matrix6> lu(Matrix6::Identity() +
                                        belief.covariance * observation.information);
  const Vector6 solution = lu.solve(error + belief.covariance * observation.gradient);
  return {moved(observation.T_model_base, solution), symmetric(lu.solve(belief.covariance))};
}

}  // namespace ribbon_mapper
