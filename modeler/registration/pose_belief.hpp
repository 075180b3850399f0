// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// (translation [m], rotation vector [rad]).
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Where a base is believed to be: a Gaussian. Its error moves the base's origin and turns the base
/// about it, both in the axes of the world.
struct PoseBelief {
  Pose T_model_base = Pose::Identity();
  Matrix6 covariance = Matrix6::Zero();
};

/// What the ribbons of one line say about its pose: least squares, linearised at a pose.
struct Observation {
  Pose T_model_base = Pose::Identity();  ///< linearised at
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();  ///< the solution is information^-1 * gradient
};

/// The pose moved by an error, and the error that moves one pose to another.
Pose moved(const Pose& T_model_base, const Vector6& error);
Vector6 error_between(const Pose& from, const Pose& to);

/// Takes an error of a base to that of a point of it that lies `lever` (in world) further on.
Matrix6 carry(const Eigen::Vector3d& lever);

/// Turns the blocks of numbers on the axes of a base to those of the world.
Matrix6 in_world(const Vector6& on_axes, const Eigen::Matrix3d& rotation);

/// The belief after a step of the odometry, and of the pose that the step was made from. Variances
/// of the step's error are in the frame of the base.
PoseBelief after_step(const PoseBelief& from, const Pose& step, const Vector6& variances);
PoseBelief before_step(const PoseBelief& to, const Pose& step, const Vector6& variances);

/// Two independent beliefs of one pose.
PoseBelief fused(const PoseBelief& a, const PoseBelief& b);

/// The belief once the observation is known.
PoseBelief updated(const PoseBelief& belief, const Observation& observation);

}  // namespace ribbon_mapper
