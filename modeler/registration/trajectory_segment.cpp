// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {
namespace {

/// Of the lines [first, end) between two corrected poses, or beyond their ends.
Span span_of(const TrackedPoses& recorded, std::uint32_t first, std::uint32_t end,
             const std::optional<TrackedPose>& from, const std::optional<TrackedPose>& to) {
  Span span;
  span.first_line = first, span.end_line = end;
  if (from) span.T_map_first = from->in_map.T_map_base;
  if (to) span.T_map_last = to->in_map.T_map_base;
  span.T_odom_base.push_back(from ? from->T_odom_base : recorded.T_odom_base()[first]);
  for (std::uint32_t i = first; i < end; ++i) span.T_odom_base.push_back(recorded.T_odom_base()[i]);
  span.T_odom_base.push_back(to ? to->T_odom_base : recorded.T_odom_base()[end - 1]);
  return span;
}

std::optional<TrackedPose> pose_at(const TrackedPoses& poses, std::size_t index) {
  return index < poses.size() ? std::optional(poses[index]) : std::nullopt;
}

}  // namespace

std::vector<Span> spans_between(const TrackedPoses& recorded, const TrackedPoses& corrected) {
  const std::vector<Time>&lines = recorded.stamps(), &ends = corrected.stamps();
  std::vector<Span> spans;
  std::uint32_t line = 0;
  for (std::size_t i = 0; i <= ends.size(); ++i) {
    if (i > 0 && line < lines.size() && lines[line] == ends[i - 1]) ++line;
    const std::uint32_t first = line;
    while (line < lines.size() && (i == ends.size() || lines[line] < ends[i])) ++line;
    if (line == first) continue;
    const auto from = i > 0 ? pose_at(corrected, i - 1) : std::nullopt;
    spans.push_back(span_of(recorded, first, line, from, pose_at(corrected, i)));
  }
  return spans;
}

std::vector<Pose> odometry_steps(const Span& span) {
  std::vector<Pose> steps;
  for (std::size_t i = 0; i + 1 < span.T_odom_base.size(); ++i) {
    steps.push_back(span.T_odom_base[i].inverse(Eigen::Isometry) * span.T_odom_base[i + 1]);
  }
  return steps;
}

}  // namespace ribbon_mapper
