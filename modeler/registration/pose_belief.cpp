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

Matrix6 transport(const Eigen::Vector3d& lever) {
  Matrix6 result = Matrix6::Identity();
  result.topRightCorner<3, 3>() = -cross_matrix(lever);
  return result;
}

Matrix6 in_model_axes(const Vector6& on_axes_of_base, const Eigen::Matrix3d& rotation) {
  Matrix6 result = Matrix6::Zero();
  result.topLeftCorner<3, 3>() =
      rotation * on_axes_of_base.head<3>().asDiagonal() * rotation.transpose();
  result.bottomRightCorner<3, 3>() =
      rotation * on_axes_of_base.tail<3>().asDiagonal() * rotation.transpose();
  return result;
}

Matrix6 in_other_axes(const Matrix6& covariance, const Eigen::Matrix3d& rotation) {
  Matrix6 both = Matrix6::Zero();
  both.topLeftCorner<3, 3>() = both.bottomRightCorner<3, 3>() = rotation;
  return symmetric(both * covariance * both.transpose());
}

PoseBelief after_step(const PoseBelief& from, const Pose& step, const Vector6& variances) {
  const Eigen::Matrix3d rotation = from.T_model_base.linear();
  const Matrix6 transported = transport(rotation * step.translation());
  return {from.T_model_base * step, transported * from.covariance * transported.transpose() +
                                        in_model_axes(variances, rotation)};
}

PoseBelief after_step(const PoseBelief& from, const Pose& step, const Matrix6& covariance) {
  const Eigen::Matrix3d rotation = from.T_model_base.linear();
  const Matrix6 transported = transport(rotation * step.translation());
  return {from.T_model_base * step, transported * from.covariance * transported.transpose() +
                                        in_other_axes(covariance, rotation)};
}

PoseBelief before_step(const PoseBelief& to, const Pose& step, const Vector6& variances) {
  const Pose T_model_base = to.T_model_base * step.inverse(Eigen::Isometry);
  const Eigen::Matrix3d rotation = T_model_base.linear();
  const Matrix6 transported = transport(-(rotation * step.translation()));
  return {T_model_base, transported * (to.covariance + in_model_axes(variances, rotation)) *
                            transported.transpose()};
}

double mean_square_sigmas(const PoseBelief& expected, const Pose& truth,
                          const std::array<int, 3>& components) {
  const Vector6 error = error_between(expected.T_model_base, truth);
  Eigen::Vector3d e;
  Eigen::Matrix3d covariance;
  for (int i = 0; i < 3; ++i) {
    e[i] = error[components[i]];
    for (int j = 0; j < 3; ++j)
      covariance(i, j) = expected.covariance(components[i], components[j]);
  }
  return e.dot(covariance.ldlt().solve(e)) / 3.0;
}

PoseBelief fused(const PoseBelief& a, const PoseBelief& b) {
  const Matrix6 gain = (a.covariance + b.covariance).ldlt().solve(a.covariance).transpose();
  const Vector6 error = gain * error_between(a.T_model_base, b.T_model_base);
  return {moved(a.T_model_base, error), symmetric(a.covariance - gain * a.covariance)};
}

PoseBelief updated(const PoseBelief& belief, const PoseInformation& measured) {
  const Vector6 error = error_between(measured.T_model_base, belief.T_model_base);
  const Eigen::PartialPivLU<Matrix6> lu(Matrix6::Identity() + belief.covariance * measured.matrix);
  const Vector6 solution = lu.solve(error + belief.covariance * measured.vector);
  return {moved(measured.T_model_base, solution), symmetric(lu.solve(belief.covariance))};
}

}  // namespace ribbon_mapper
