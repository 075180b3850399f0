// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/registration/pose_belief.hpp"
#include "modeler/trajectory/tracked_poses.hpp"

namespace ribbon_mapper {

/// Successive lines strictly between two corrected poses, linked by the odometry. The segments
/// before the first and after the last corrected pose have one open end.
///
/// Poses are in one frame: map if the segment comes from segments_between(), the model frame if it
/// is given to the smoother or to the adjustment. in_frame() converts.
struct TrajectorySegment {
  std::uint32_t first_line = 0;  ///< index of its first line in the trajectory
  std::uint32_t end_line = 0;    ///< index behind its last line

  /// Motions of the base by odometry: from the start to the first line, from line to line, and from
  /// the last line to the end. There is one more than lines. An open end lies at its next line.
  std::vector<Pose> steps;
  /// Variances of the steps' errors, along the axes of the base before the step [m2, rad2]. Empty
  /// until set_step_variances() is called.
  std::vector<Vector6> step_variances;

  std::optional<Pose> T_frame_start;  ///< corrected pose before the first line, if any
  std::optional<Pose> T_frame_end;    ///< corrected pose behind the last line, if any

  /// Returns the number of lines.
  std::uint32_t lines() const { return end_line - first_line; }
  /// Returns true if one end is not known.
  bool is_open() const { return !T_frame_start || !T_frame_end; }
};

/// Returns all segments of at least one line, in order of time, without step variances and with
/// ends in map. `corrected` holds poses in map with the odometry of their time and is not empty.
/// A line at the stamp of a corrected pose belongs to no segment.
std::vector<TrajectorySegment> segments_between(const TrackedPoses& recorded,
                                                const TrackedPoses& corrected);

/// Returns the segment with its ends in another frame. `T_frame_other` is the pose of that frame.
TrajectorySegment in_frame(TrajectorySegment segment, const Pose& T_frame_other);

}  // namespace ribbon_mapper
