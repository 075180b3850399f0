// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "modeler/chain/matrix6.hpp"
#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// A Gaussian belief of a base's pose in the model frame. Its error moves the base's origin and
/// rotates the base about that origin, both along the axes of the model frame.
struct PoseBelief {
  Pose T_model_base = Pose::Identity();  ///< mean
  Matrix6 covariance = Matrix6::Zero();  ///< of the error [m2, m rad, rad2]
};

/// What measurements say about a pose, in information form and linearised at a pose. The error of
/// that pose which fits them best is matrix^-1 * vector.
struct PoseInformation {
  Pose T_model_base = Pose::Identity();  ///< pose of the linearisation
  Matrix6 matrix = Matrix6::Zero();      ///< information matrix, may be singular
  Vector6 vector = Vector6::Zero();      ///< information vector
};

/// Returns the pose moved by an error.
Pose moved(const Pose& T_model_base, const Vector6& error);

/// Returns the error that moves the pose `from` to the pose `to`: the inverse of moved().
Vector6 error_between(const Pose& from, const Pose& to);

/// Returns the Jacobian of a point's error by the error of a base that carries it. `lever` leads
/// from the base's origin to the point [m], along the axes of the model frame.
Matrix6 transport(const Eigen::Vector3d& lever);

/// Returns diagonal blocks, given along the axes of a base, along those of the model frame.
/// `rotation` takes vectors of the base to the model frame.
Matrix6 in_model_axes(const Vector6& on_axes_of_base, const Eigen::Matrix3d& rotation);

/// Returns a covariance, given along the axes of one frame, along those of another. `rotation`
/// takes vectors of the first to the second.
Matrix6 in_other_axes(const Matrix6& covariance, const Eigen::Matrix3d& rotation);

/// Returns the belief after an odometry step. `variances` of the step's error are along the axes of
/// the base before the step.
PoseBelief after_step(const PoseBelief& from, const Pose& step, const Vector6& variances);
/// Returns the same for a covariance of the step's error, along the same axes.
PoseBelief after_step(const PoseBelief& from, const Pose& step, const Matrix6& covariance);

/// Returns the belief before an odometry step that has led to `to`: the reverse of after_step().
PoseBelief before_step(const PoseBelief& to, const Pose& step, const Vector6& variances);

/// Returns the squared error of a belief in standard deviations, for each of three components of
/// Vector6: kInPlane or kOutOfPlane. It is 1 on average if the covariance is right.
double mean_square_sigmas(const PoseBelief& expected, const Pose& truth,
                          const std::array<int, 3>& components);

/// Returns the product of two independent beliefs of one pose. At most one may be certain.
PoseBelief fused(const PoseBelief& a, const PoseBelief& b);

/// Returns the belief once independent measurements of the pose are taken into account.
PoseBelief updated(const PoseBelief& belief, const PoseInformation& measured);

}  // namespace ribbon_mapper
