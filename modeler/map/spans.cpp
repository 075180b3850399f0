// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/spans.hpp"

namespace ribbon_mapper {
namespace {

/// The lines from `first` on that lie before `to`, behind `from`; null: no corrected pose.
Span span_from(const std::vector<RecordedPose>& recorded, std::uint32_t first,
               const RecordedPose* from, const RecordedPose* to) {
  Span span;
  span.first_line = first;
  std::uint32_t end = first;
  while (end < recorded.size() && (!to || recorded[end].in_map.stamp < to->in_map.stamp)) ++end;
  span.end_line = end;
  if (end == first) return span;
  if (from) span.T_map_first = from->in_map.T_map_base;
  if (to) span.T_map_last = to->in_map.T_map_base;
  span.T_odom_base.push_back((from ? *from : recorded[first]).T_odom_base);
  for (std::uint32_t i = first; i < end; ++i) span.T_odom_base.push_back(recorded[i].T_odom_base);
  span.T_odom_base.push_back((to ? *to : recorded[end - 1]).T_odom_base);
  return span;
}

}  // namespace

std::vector<Span> spans_between(const std::vector<RecordedPose>& recorded,
                                const std::vector<RecordedPose>& corrected) {
  std::vector<Span> spans;
  std::uint32_t line = 0;
  for (std::size_t i = 0; i <= corrected.size(); ++i) {
    const RecordedPose* from = i > 0 ? &corrected[i - 1] : nullptr;
    const RecordedPose* to = i < corrected.size() ? &corrected[i] : nullptr;
    if (from && line < recorded.size() && recorded[line].in_map.stamp == from->in_map.stamp) ++line;
    Span span = span_from(recorded, line, from, to);
    line = span.end_line;
    if (span.lines() > 0) spans.push_back(std::move(span));
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
