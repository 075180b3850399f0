// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/odometry_noise.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

using Indices = std::array<int, 3>;
constexpr Indices in_plane{0, 1, 5}, out_of_plane{2, 3, 4};
constexpr double min_scale = 0.01;
// What a step's error has at least, that beliefs stay regular: 0.01 mm, 0.01 mrad.
constexpr double min_variance = 1e-10;

/// Square of an error in sigmas, per component.
double mean_square_of(const PoseBelief& expected, const Pose& truth, const Indices& of) {
  const Vector6 error = error_between(expected.T_model_base, truth);
  Eigen::Vector3d e;
  Eigen::Matrix3d covariance;
  for (int i = 0; i < 3; ++i) {
    e[i] = error[of[i]];
    for (int j = 0; j < 3; ++j) covariance(i, j) = expected.covariance(of[i], of[j]);
  }
  return e.dot(covariance.ldlt().solve(e)) / 3.0;
}

}  // namespace

Vector6 OdometryNoise::variances(const Pose& step) const {
  const double drives = step.translation().norm() / linear_update_m,
               turns = angle_of(step) / angular_update_rad;
  const auto variance = [&](double per_drive, double per_turn) {
    return square(per_drive * linear_update_m) * drives +
           square(per_turn * angular_update_rad) * turns;
  };
  const double x = variance(srr, str), y = variance(0.3 * srr, str), yaw = variance(srt, stt);
  const double p = square(planar), s = square(spatial);
  Vector6 result;
  result << p * x, p * y, s * y, s * yaw, s * yaw, p * yaw;
  return result.array() + min_variance;
}

OdometryNoise fitted_to(const std::vector<OdometryCheck>& checks) {
  OdometryNoise noise;
  double planar = 0.0, spatial = 0.0;
  for (const OdometryCheck& check : checks) {
    PoseBelief belief;
    for (const Pose& step : check.steps) {
      belief = after_step(belief, step, noise.variances(step));
    }
    planar += mean_square_of(belief, check.T_first_last_true, in_plane);
    spatial += mean_square_of(belief, check.T_first_last_true, out_of_plane);
  }
  const auto count = static_cast<double>(checks.size());
  noise.planar = std::max(min_scale, std::sqrt(planar / count));
  noise.spatial = std::max(min_scale, std::sqrt(spatial / count));
  return noise;
}

}  // namespace ribbon_mapper
