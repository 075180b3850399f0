// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/observations/observations.hpp"
#include "slam/tilting/line_tracker.hpp"
#include "slam/tilting/noise_scale.hpp"

namespace ribbon_mapper::slam {

/// Estimates the trajectory from odometry and ribbons alone.
class TrajectoryEstimate {
 public:
  /// Starts without lines. `observations` hold those that will be added, and must outlive this.
  TrajectoryEstimate(const Observations& observations, const EstimateSettings& settings);

  /// Adds a line whose ribbons are the last ones. Returns true if older poses were revised.
  bool add_line(Time stamp, const Pose& T_odom_base);
  /// Returns the number of lines.
  std::size_t line_count() const { return lines_.size(); }
  /// Adjusts the whole trajectory.
  void finish();

  /// Returns the learnt scale of the odometry's noise, as OdometryNoise::planar_scale.
  double noise_scale() const { return noise_.planar_scale; }
  /// Returns the estimated pose of each line, in the odometry's frame at the first line.
  std::vector<StampedPose> trajectory() const;

 private:
  void adjust_window();
  std::vector<std::uint32_t> context_of(std::uint32_t first) const;

  EstimateSettings settings_;
  NoiseScale noise_scale_;
  OdometryNoise noise_;
  PosedLines lines_;
  LineTracker tracker_;
  Pose T_odom_start_ = Pose::Identity();
  std::uint32_t settled_ = 0;      // lines before it have left all windows
  std::uint32_t window_line_ = 0;  // the last one that was adjusted
};

}  // namespace ribbon_mapper::slam
