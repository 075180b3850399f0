// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper::sim {

/// A periodic motion of laser_tilt_mount_joint as LaserScannerTrajController runs it.
struct TiltProfileConfig {
  enum class Shape {
    linear,          ///< constant rate between the points
    blended_linear,  ///< from rest to rest: constant acceleration, cruise, constant braking
  };
  Shape shape = Shape::linear;
  std::vector<double> positions_rad = {-0.5, 1.0, -0.5};  ///< first equals last; cut at the limits
  std::vector<double> times_s = {0.0, 1.5, 3.0};  ///< from 0, increasing; last is the period
  double max_acceleration_rad_s2 = 30.0;  ///< of blended_linear (pr2_laser_tilt_controller.yaml)

  /// pr2_msgs/PeriodicCmd `linear`: starts at offset - amplitude (up), down after half a period.
  static TiltProfileConfig linear(double period_s, double amplitude_rad, double offset_rad);
  /// `manip` (linear 3 s), `nav` (pr2_move_base.py) or `slow` (linear 10 s).
  /// Throws std::invalid_argument naming these.
  static TiltProfileConfig preset(const std::string& name);
  void validate() const;  ///< throws std::invalid_argument naming the key and its range
};

class TiltProfile {
 public:
  /// Throws std::invalid_argument if the configuration is not valid.
  explicit TiltProfile(const TiltProfileConfig& config);
  /// laser_tilt_mount_joint [rad], positive looks down. Any time from 0 on.
  double angle_rad(Time time) const;
  double period_s() const { return config_.times_s.back(); }

 private:
  TiltProfileConfig config_;
};

}  // namespace ribbon_mapper::sim
