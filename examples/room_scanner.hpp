// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "modeler/modeler.hpp"

/// A tilting laser in an empty room of 6 x 5 x 2.5 m, whose ranges are known in closed form. It
/// takes the place of a driver and tf in the examples.
namespace room_scanner {

using ribbon_mapper::Pose;
/// A pose as a function of time [s].
using PoseAtTime = std::function<Pose(double time_s)>;

constexpr int kBeams = 361;                ///< beams of a line, over 180 degrees
constexpr double kLinePeriod_s = 0.025;    ///< time from line to line
constexpr double kBeamPeriod_s = 0.00005;  ///< time from beam to beam

/// Returns the laser's pose in base, 1.2 m above the floor: it tilts within +-1.2 rad at 0.8 rad/s.
inline Pose T_base_laser(double time_s) {
  const double periods = time_s * 0.8 / 4.8;
  const double tilt_rad = 1.2 * (4.0 * std::abs(periods - std::round(periods)) - 1.0);
  return Eigen::Translation3d(0.0, 0.0, 1.2) *
         Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitY());
}

/// Returns the distance from a point in the room to its boundary along a unit vector [m].
inline double range_m(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d low(-3.0, -2.5, 0.0), high(3.0, 2.5, 2.5);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;  // parallel to the wall
    const double wall = direction[axis] > 0.0 ? high[axis] : low[axis];
    nearest_m = std::min(nearest_m, std::abs((wall - origin[axis]) / direction[axis]));
  }
  return nearest_m;
}

/// Returns line `index` (0, 1, ...) of a robot that moves along `T_map_base`.
inline ribbon_mapper::LaserBeams beams_of_line(int index, const PoseAtTime& T_map_base) {
  ribbon_mapper::LaserBeams line;
  line.stamp = ribbon_mapper::from_seconds(1.0 + index * kLinePeriod_s);
  line.angle_min_rad = -M_PI_2;
  line.angle_increment_rad = M_PI / (kBeams - 1);
  line.time_increment_s = kBeamPeriod_s;
  line.range_min_m = 0.1;
  line.range_max_m = 30.0;
  for (int beam = 0; beam < kBeams; ++beam) {
    const double time_s = ribbon_mapper::to_seconds(line.stamp) + beam * kBeamPeriod_s;
    const double angle_rad = line.angle_min_rad + beam * line.angle_increment_rad;
    const Pose T_map_laser = T_map_base(time_s) * T_base_laser(time_s);
    const Eigen::Vector3d direction(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    const double range = range_m(T_map_laser.translation(), T_map_laser.linear() * direction);
    line.ranges_m.push_back(static_cast<float>(range));
  }
  return line;
}

/// Returns the poses that tf would report for line `index` if the robot were localised at
/// `T_map_base`.
inline ribbon_mapper::LinePoses poses_of_line(int index, const PoseAtTime& T_map_base) {
  const double first_s = 1.0 + index * kLinePeriod_s;
  const double last_s = first_s + (kBeams - 1) * kBeamPeriod_s;
  return {T_map_base(first_s), T_map_base(last_s), T_base_laser(first_s), T_base_laser(last_s),
          T_map_base(0.5 * (first_s + last_s))};
}

}  // namespace room_scanner
