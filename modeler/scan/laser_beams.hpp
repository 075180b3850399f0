// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// One rotation of a 2D laser as its driver reports it: sensor_msgs/LaserScan without ROS.
///
/// Beam i points at `angle_min + i * angle_increment` about the +z axis of the laser's frame, with
/// 0 along +x. It is fired at `stamp + i * time_increment`. A range is a return only if it is
/// finite and within [range_min, range_max] (REP 117).
struct LaserBeams {
  Time stamp{0};                     ///< time of the first beam
  double angle_min_rad = 0.0;        ///< angle of the first beam
  double angle_increment_rad = 0.0;  ///< angle from each beam to the next, not 0
  double time_increment_s = 0.0;     ///< time from each beam to the next
  double range_min_m = 0.0;          ///< smallest valid range
  double range_max_m = 0.0;          ///< largest valid range
  std::vector<float> ranges_m;       ///< range of each beam
};

/// The poses of robot and laser while the beams of a line are fired. "First" and "last" refer to
/// the times of the first and the last beam; between them, poses are interpolated. `odom` is any
/// frame in which the robot's motion is continuous (REP 105); only motion within it is used.
struct LinePoses {
  Pose T_odom_base_first = Pose::Identity();   ///< base in odom at the first beam
  Pose T_odom_base_last = Pose::Identity();    ///< base in odom at the last beam
  Pose T_base_laser_first = Pose::Identity();  ///< laser in base at the first beam
  Pose T_base_laser_last = Pose::Identity();   ///< laser in base at the last beam
  /// Acquisition pose: base_footprint in map, half way between the first and the last beam.
  Pose T_map_base = Pose::Identity();
};

/// Returns the time half way between the first and the last beam.
inline Time middle_of(const LaserBeams& beams) {
  const double beams_after_first =
      beams.ranges_m.empty() ? 0.0 : static_cast<double>(beams.ranges_m.size() - 1);
  return beams.stamp + from_seconds(0.5 * beams_after_first * beams.time_increment_s);
}

/// Returns the time of the last beam.
inline Time end_of(const LaserBeams& beams) {
  const double beams_after_first =
      beams.ranges_m.empty() ? 0.0 : static_cast<double>(beams.ranges_m.size() - 1);
  return beams.stamp + from_seconds(beams_after_first * beams.time_increment_s);
}

}  // namespace ribbon_mapper
