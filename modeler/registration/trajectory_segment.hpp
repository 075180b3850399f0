// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/trajectory/tracked_poses.hpp"

namespace ribbon_mapper {

/// Successive lines without a corrected pose among them: strictly between two corrected poses, or,
/// with one loose end, before the first or after the last one.
struct Span {
  std::uint32_t first_line = 0, end_line = 0;   ///< [first, end) of the recorded poses
  std::optional<Pose> T_map_first, T_map_last;  ///< the corrected poses at its ends
  /// Of first end, lines, last end; a loose end is where its next line is.
  std::vector<Pose> T_odom_base;

  std::uint32_t lines() const { return end_line - first_line; }
  bool has_loose_end() const { return !T_map_first || !T_map_last; }
};

/// All spans of at least one line, in order. `corrected`: poses in map with the odometry of their
/// time, not empty.
std::vector<Span> spans_between(const TrackedPoses& recorded, const TrackedPoses& corrected);

/// From each of the span's poses to the next.
std::vector<Pose> odometry_steps(const Span& span);

}  // namespace ribbon_mapper
