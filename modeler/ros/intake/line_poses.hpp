// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <string>
#include <variant>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Names of the frames in tf (REP 105). On the PR2, odom is called odom_combined.
struct Frames {
  std::string map = "map";              ///< of the localisation
  std::string odom = "odom_combined";   ///< of odometry
  std::string base = "base_footprint";  ///< of the robot, on the floor
};

/// A transform that tf does not have, or not yet.
struct MissingTransform {
  std::string reason;  ///< names the frame or the two frames; the same for all lines that lack it
  std::string detail;  ///< the message of tf2, with times
};

/// Returns the poses of robot and laser at the first and the last beam, and that of the base in map
/// half way between; or the first transform that is missing.
std::variant<LinePoses, MissingTransform> find_line_poses(const tf2::BufferCore& tf,
                                                          const Frames& frames,
                                                          const std::string& laser_frame,
                                                          const LaserBeams& beams);

}  // namespace ribbon_mapper
