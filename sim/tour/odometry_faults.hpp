// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::sim {

/// Errors of the odometry that are no noise: wheels that slip, a robot that is pushed, wrong
/// scales. The true motion is always that of the route. By default there are none.
struct OdometryFaults {
  /// Wheels that spin: the odometry reports a motion that the robot does not make. It lasts as long
  /// as the PR2's fastest motion of that size (1 m/s, 2 rad/s).
  struct Slip {
    double start_s = 0.0;    ///< from the start of the tour
    double forward_m = 0.0;  ///< reported along the robot's x
    double turn_rad = 0.0;   ///< reported about z
    /// Returns the time that it lasts.
    double duration_s() const;
  };
  /// A robot that is pushed along its route: the odometry reports no motion.
  struct Push {
    double start_s = 0.0;     ///< from the start of the tour
    double duration_s = 0.0;  ///< time that it lasts
  };
  std::vector<Slip> slips;   ///< in any order; motions that overlap add up
  std::vector<Push> pushes;  ///< in any order
  double scale = 1.0;        ///< multiplies every reported way, as a wrong wheel radius does
  double yaw_scale = 1.0;    ///< multiplies every reported turn, as a wrong wheel base does

  /// Reads a list such as "slip=30:20,shift=40:0.5,push=60:2,scale=1.02,yaw_scale=0.97". These are
  /// a slip of 20 degrees at 30 s, one of 0.5 m at 40 s, and a push of 2 s at 60 s. Empty text
  /// gives no fault. Throws std::invalid_argument that names what is wrong and what is allowed.
  static OdometryFaults from(const std::string& text);

  /// Throws std::invalid_argument that names a wrong value and its range.
  void validate() const;

  /// Returns the motion that the odometry reports between two times of the tour [s]. `step` is the
  /// true motion between them, in the frame of the base. Without faults it is returned unchanged.
  Pose reported(const Pose& step, double begin_s, double end_s) const;
};

}  // namespace ribbon_mapper::sim
