// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

namespace ribbon_mapper {

/// An error of a pose, or its variances: translation [m], then rotation vector [rad].
using Vector6 = Eigen::Matrix<double, 6, 1>;
/// A covariance, an information matrix or a Jacobian in the order of Vector6.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// x, y and yaw in a Vector6 on axes of which the third is upright.
inline constexpr std::array<int, 3> kInPlane{0, 1, 5};
/// z, roll and pitch, the same.
inline constexpr std::array<int, 3> kOutOfPlane{2, 3, 4};

}  // namespace ribbon_mapper
