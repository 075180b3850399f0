// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper::sim {

/// A periodic motion of laser_tilt_mount_joint, as run by LaserScannerTrajController.
struct TiltProfileConfig {
  /// The motion between two points.
  enum class Shape {
    linear,          ///< constant rate between the points
    blended_linear,  ///< from rest to rest: constant acceleration, cruise, constant braking
  };
  Shape shape = Shape::linear;                            ///< of all segments
  std::vector<double> positions_rad = {-0.5, 1.0, -0.5};  ///< first equals last; clamped
  std::vector<double> times_s = {0.0, 1.5, 3.0};          ///< increase from 0 to the period
  double max_acceleration_rad_s2 = 30.0;  ///< of blended_linear (pr2_laser_tilt_controller.yaml)

  /// Returns the profile of pr2_msgs/PeriodicCmd `linear`: starts at offset - amplitude (up) and is
  /// down after half a period.
  static TiltProfileConfig linear(double period_s, double amplitude_rad, double offset_rad);

  /// Returns the profile called `name`: manip (linear 3 s), nav (pr2_move_base.py) or slow (linear
  /// 10 s). Throws std::invalid_argument that lists the names.
  static TiltProfileConfig preset(const std::string& name);

  /// Throws std::invalid_argument that names a wrong key and its range.
  void validate() const;
};

/// The tilt of the laser as a function of time.
class TiltProfile {
 public:
  /// Clamps the positions to the limits of the joint. Throws std::invalid_argument if the
  /// configuration is not valid.
  explicit TiltProfile(const TiltProfileConfig& config);
  /// Returns the position of laser_tilt_mount_joint at `time`, from 0 on; positive looks down.
  double angle_rad(Time time) const;
  /// Returns the duration of one period.
  double period_s() const { return config_.times_s.back(); }

 private:
  TiltProfileConfig config_;
};

}  // namespace ribbon_mapper::sim
