// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// One rotation of a 2D laser as its driver reports it (sensor_msgs/LaserScan without ROS).
/// Beam i points at `angle_min + i * angle_increment` about the laser frame's +z, 0 along +x, and
/// was fired at `stamp + i * time_increment`. A range is a return only if it is finite and within
/// [range_min, range_max] (REP 117).
struct LaserBeams {
  Time stamp{0};
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double time_increment_s = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m;
};

/// Where the robot and its laser were while the beams were fired. "First" and "last" are the times
/// of the first and the last beam; in between, poses are interpolated. `odom` is any frame in which
/// the robot's motion is continuous (REP 105); only motion within it is used. `T_map_base` is the
/// acquisition pose: base_footprint in map half way between first and last.
struct LinePoses {
  Pose T_odom_base_first = Pose::Identity();
  Pose T_odom_base_last = Pose::Identity();
  Pose T_base_laser_first = Pose::Identity();
  Pose T_base_laser_last = Pose::Identity();
  Pose T_map_base = Pose::Identity();
};

/// Time half way between the first and the last beam.
inline Time middle_of(const LaserBeams& beams) {
  const double beams_after_first =
      beams.ranges_m.empty() ? 0.0 : static_cast<double>(beams.ranges_m.size() - 1);
  return beams.stamp + from_seconds(0.5 * beams_after_first * beams.time_increment_s);
}

/// Time of the last beam.
inline Time end_of(const LaserBeams& beams) {
  const double beams_after_first =
      beams.ranges_m.empty() ? 0.0 : static_cast<double>(beams.ranges_m.size() - 1);
  return beams.stamp + from_seconds(beams_after_first * beams.time_increment_s);
}

}  // namespace ribbon_mapper
