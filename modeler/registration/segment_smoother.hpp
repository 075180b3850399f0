// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "modeler/registration/pose_belief.hpp"
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {

/// A forward-backward smoother of the poses of a segment's lines (the two-filter form of Rauch,
/// Tung, Striebel 1965). Without measurements it is a random walk between the segment's ends.
///
/// Each line is measured where its neighbours and the ends place it. Certainty thus grows from the
/// ends inwards, and a ribbon is matched only once its line's pose is known as well as it can be.
class SegmentSmoother {
 public:
  /// Measures the pose of the line of an index within the segment. `without_it` is the belief from
  /// everything but the line's own measurements.
  using Measure = std::function<PoseInformation(std::size_t line, const PoseBelief& without_it)>;

  /// Propagates the ends by odometry alone. Throws std::invalid_argument if no end is known, or if
  /// the numbers of steps and of their variances are not one more than that of the lines.
  explicit SegmentSmoother(const TrajectorySegment& segment);

  /// Returns the number of lines.
  std::size_t lines() const { return forward_.size(); }

  /// Returns the belief of a line's pose without its own measurements: from odometry and ends, and
  /// from the measurements of all other lines once smooth() was called.
  PoseBelief without(std::size_t line) const { return fused(forward_[line], backward_[line]); }

  /// Measures all lines in one forward and one backward pass.
  void smooth(const Measure& measure);

 private:
  void forward_pass(const Measure* measure);
  void backward_pass(const Measure* measure);

  TrajectorySegment segment_;
  PoseBelief start_, end_;
  std::vector<PoseBelief> forward_;   // by line, from everything before it
  std::vector<PoseBelief> backward_;  // by line, from everything behind it
};

}  // namespace ribbon_mapper
