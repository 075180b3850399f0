// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/segment_smoother.hpp"

#include <stdexcept>

namespace ribbon_mapper {
namespace {

// An open end may lie anywhere: 10 m and 10 rad are far beyond what a segment can drift.
constexpr double kOpenEndVariance = 100.0;

PoseBelief belief_of_end(const std::optional<Pose>& end, const Pose& by_odometry) {
  if (end) return {*end, Matrix6::Zero()};
  return {by_odometry, kOpenEndVariance * Matrix6::Identity()};
}

const TrajectorySegment& checked(const TrajectorySegment& segment) {
  const std::size_t steps = segment.lines() + std::size_t{1};
  if (segment.steps.size() != steps || segment.step_variances.size() != steps) {
    throw std::invalid_argument(
        "segment smoother: needs one step and its variances per line, and "
        "those to the end; call set_step_variances() first");
  }
  if (!segment.T_frame_start && !segment.T_frame_end) {
    throw std::invalid_argument("segment smoother: at least one end must be known");
  }
  return segment;
}

}  // namespace

SegmentSmoother::SegmentSmoother(const TrajectorySegment& segment)
    : segment_(checked(segment)), forward_(segment.lines()), backward_(segment.lines()) {
  Pose T_start_end = Pose::Identity();
  for (const Pose& step : segment_.steps) T_start_end = T_start_end * step;
  const std::optional<Pose>&start = segment_.T_frame_start, &end = segment_.T_frame_end;
  const Pose origin = Pose::Identity();
  start_ = belief_of_end(start, end.value_or(origin) * T_start_end.inverse(Eigen::Isometry));
  end_ = belief_of_end(end, start.value_or(origin) * T_start_end);
  forward_pass(nullptr);
  backward_pass(nullptr);
}

void SegmentSmoother::smooth(const Measure& measure) {
  forward_pass(&measure);
  backward_pass(&measure);
}

void SegmentSmoother::forward_pass(const Measure* measure) {
  PoseBelief belief = start_;
  for (std::size_t line = 0; line < lines(); ++line) {
    belief = after_step(belief, segment_.steps[line], segment_.step_variances[line]);
    forward_[line] = belief;
    if (measure) belief = updated(belief, (*measure)(line, without(line)));
  }
}

void SegmentSmoother::backward_pass(const Measure* measure) {
  PoseBelief belief = end_;
  for (std::size_t line = lines(); line-- > 0;) {
    belief = before_step(belief, segment_.steps[line + 1], segment_.step_variances[line + 1]);
    backward_[line] = belief;
    if (measure) belief = updated(belief, (*measure)(line, without(line)));
  }
}

}  // namespace ribbon_mapper
