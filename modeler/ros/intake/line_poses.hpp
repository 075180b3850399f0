// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <string>
#include <variant>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Names of the frames in tf (REP 105; on the PR2 odom is odom_combined).
struct Frames {
  std::string map = "map";
  std::string odom = "odom_combined";
  std::string base = "base_footprint";
};

/// A transform that tf does not have (yet).
struct MissingTransform {
  std::string reason;  ///< names the frame or the two frames; the same for all lines that lack it
  std::string detail;  ///< what tf2 says, with times
};

/// Where robot and laser were during a line: at the first and the last beam, map half way between.
std::variant<LinePoses, MissingTransform> find_line_poses(const tf2::BufferCore& tf,
                                                          const Frames& frames,
                                                          const std::string& laser_frame,
                                                          const LaserBeams& beams);

}  // namespace ribbon_mapper
