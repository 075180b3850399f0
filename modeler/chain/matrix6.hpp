// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace ribbon_mapper {

/// An error of a pose, or its variances: translation [m], then rotation vector [rad].
using Vector6 = Eigen::Matrix<double, 6, 1>;
/// A covariance, an information matrix or a Jacobian in the order of Vector6.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

}  // namespace ribbon_mapper
