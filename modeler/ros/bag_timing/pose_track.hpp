// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "modeler/ros/intake/line_poses.hpp"

namespace ribbon_mapper {

/// The poses of robot and laser as functions of time, sampled from tf every 5 ms. Much faster to
/// look up than tf itself.
class PoseTrack {
 public:
  /// Samples the poses from `from` to `to`.
  PoseTrack(const tf2::BufferCore& tf, const Frames& frames, const std::string& laser_frame,
            Time from, Time to);

  /// Returns the poses of a line, or nothing where tf has none.
  std::optional<LinePoses> poses_of(const LaserBeams& beams) const;

 private:
  struct Sample {
    Pose T_odom_base, T_base_laser, T_map_base;
  };
  std::optional<Sample> at(Time time) const;

  Time from_;
  std::vector<std::optional<Sample>> samples_;
};

}  // namespace ribbon_mapper
