// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/odometry_noise.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kMostSquare = 16.0;  // a slip is no noise: the prior is robust against it

}  // namespace

Eigen::Vector3d PlanarOdometryNoise::deviations(const PlanarPose& step) const {
  const double way = step.translation().norm(), turn = std::abs(step.yaw_rad);
  const double xy = std::hypot(config_.per_metre_m * way, config_.at_rest_m);
  const double yaw =
      std::hypot(config_.per_radian_rad * turn + config_.per_metre_rad * way, config_.at_rest_rad);
  return {xy, xy, yaw};
}

double PlanarOdometryNoise::scale_xy() const {
  return std::clamp(std::sqrt(square_xy_), config_.least_scale, config_.most_scale);
}

double PlanarOdometryNoise::scale_yaw() const {
  return std::clamp(std::sqrt(square_yaw_), config_.least_scale, config_.most_scale);
}

Eigen::Matrix3d PlanarOdometryNoise::information(const PlanarPose& step) const {
  Eigen::Vector3d d = deviations(step);
  d.head<2>() *= scale_xy(), d.z() *= scale_yaw();
  return d.array().square().inverse().matrix().asDiagonal();
}

void PlanarOdometryNoise::learn(const PlanarPose& step, const PlanarPose& error) {
  const Eigen::Vector3d d = deviations(step);
  const double xy = error.translation().squaredNorm() / (2.0 * square(d.x()));
  const double yaw = square(error.yaw_rad / d.z());
  steps_ = std::min(config_.memory, steps_ + 1.0);
  square_xy_ += (std::min(xy, kMostSquare) - square_xy_) / steps_;
  square_yaw_ += (std::min(yaw, kMostSquare) - square_yaw_) / steps_;
}

}  // namespace ribbon_mapper::slam
