// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/registration/odometry_noise.hpp"
#include "slam/tilting/posed_lines.hpp"

namespace ribbon_mapper::slam {

/// Learns the scale of the odometry's noise from adjusted poses.
///
/// Over spans of two seconds, the odometry's motion is compared with the adjusted one. The mean
/// squared error, in standard deviations, is that of the noise itself, but for what the adjustment
/// cannot tell from it.
class NoiseScale {
 public:
  /// Starts with an assumed scale, which counts as much as kPriorSpans spans.
  explicit NoiseScale(double assumed);

  /// Takes lines [first, end) into account, whose poses are adjusted.
  void learn(const PosedLines& lines, std::uint32_t first, std::uint32_t end);

  /// Returns the scale of the standard deviations of x, y and yaw, as OdometryNoise::planar_scale.
  double planar_scale() const;

 private:
  double assumed_;
  double square_sum_ = 0.0;
  double spans_ = 0.0;
};

}  // namespace ribbon_mapper::slam
