// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/odometry_noise.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

// A floor that is level to 0.1 mrad: what remains of an odometry that shows no error.
constexpr double kMinScale = 0.01;
// 0.01 mm and 0.01 mrad, far below any sensor, so that beliefs stay regular.
constexpr double kMinVariance = 1e-10;
// gmapping, motionmodel.cpp: a translation errs to the side by this part of its error ahead.
constexpr double kSidewaysShare = 0.3;

}  // namespace

Vector6 OdometryNoise::variances(const Pose& step) const {
  const double drives = step.translation().norm() / linear_update_m,
               turns = angle_of(step) / angular_update_rad;
  const auto variance = [&](double per_drive, double per_turn) {
    return square(per_drive * linear_update_m) * drives +
           square(per_turn * angular_update_rad) * turns;
  };
  const double x = variance(srr, str), y = variance(kSidewaysShare * srr, str),
               yaw = variance(srt, stt);
  const double p = square(planar_scale), s = square(spatial_scale);
  Vector6 result;
  result << p * x, p * y, s * y, s * yaw, s * yaw, p * yaw;
  return result.array() + kMinVariance;
}

OdometryNoise fitted_noise(const std::vector<TrajectorySegment>& segments) {
  OdometryNoise noise;
  double planar = 0.0, spatial = 0.0, count = 0.0;
  for (const TrajectorySegment& segment : segments) {
    if (segment.is_open()) continue;
    PoseBelief belief;
    for (const Pose& step : segment.steps) {
      belief = after_step(belief, step, noise.variances(step));
    }
    const Pose T_start_end = segment.T_frame_start->inverse(Eigen::Isometry) * *segment.T_frame_end;
    planar += mean_square_sigmas(belief, T_start_end, kInPlane);
    spatial += mean_square_sigmas(belief, T_start_end, kOutOfPlane);
    count += 1.0;
  }
  if (count == 0.0) throw std::invalid_argument("odometry noise: no segment has two known ends");
  noise.planar_scale = std::max(kMinScale, std::sqrt(planar / count));
  noise.spatial_scale = std::max(kMinScale, std::sqrt(spatial / count));
  return noise;
}

void set_step_variances(const OdometryNoise& noise, TrajectorySegment& segment) {
  segment.step_variances.clear();
  for (const Pose& step : segment.steps) segment.step_variances.push_back(noise.variances(step));
}

}  // namespace ribbon_mapper
