// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {
namespace {

/// The segment of the lines [first, end). An end is open if there is no corrected pose.
TrajectorySegment segment_of(const TrackedPoses& recorded, std::uint32_t first, std::uint32_t end,
                             const std::optional<TrackedPose>& from,
                             const std::optional<TrackedPose>& to) {
  TrajectorySegment segment;
  segment.first_line = first, segment.end_line = end;
  if (from) segment.T_frame_start = from->in_map.T_map_base;
  if (to) segment.T_frame_end = to->in_map.T_map_base;
  Pose T_odom_base = from ? from->T_odom_base : recorded.T_odom_base()[first];
  const auto step_to = [&](const Pose& T_odom_next) {
    segment.steps.push_back(T_odom_base.inverse(Eigen::Isometry) * T_odom_next);
    T_odom_base = T_odom_next;
  };
  for (std::uint32_t i = first; i < end; ++i) step_to(recorded.T_odom_base()[i]);
  step_to(to ? to->T_odom_base : recorded.T_odom_base()[end - 1]);
  return segment;
}

std::optional<TrackedPose> pose_at(const TrackedPoses& poses, std::size_t index) {
  return index < poses.size() ? std::optional(poses[index]) : std::nullopt;
}

}  // namespace

std::vector<TrajectorySegment> segments_between(const TrackedPoses& recorded,
                                                const TrackedPoses& corrected) {
  const std::vector<Time>&lines = recorded.stamps(), &ends = corrected.stamps();
  std::vector<TrajectorySegment> segments;
  std::uint32_t line = 0;
  for (std::size_t i = 0; i <= ends.size(); ++i) {
    if (i > 0 && line < lines.size() && lines[line] == ends[i - 1]) ++line;
    const std::uint32_t first = line;
    while (line < lines.size() && (i == ends.size() || lines[line] < ends[i])) ++line;
    if (line == first) continue;
    const auto from = i > 0 ? pose_at(corrected, i - 1) : std::nullopt;
    segments.push_back(segment_of(recorded, first, line, from, pose_at(corrected, i)));
  }
  return segments;
}

TrajectorySegment in_frame(TrajectorySegment segment, const Pose& T_frame_other) {
  const Pose T_other_frame = T_frame_other.inverse(Eigen::Isometry);
  for (std::optional<Pose>* end : {&segment.T_frame_start, &segment.T_frame_end}) {
    if (*end) **end = T_other_frame * **end;
  }
  return segment;
}

}  // namespace ribbon_mapper
