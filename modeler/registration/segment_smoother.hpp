// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "modeler/registration/odometry_noise.hpp"
#include "modeler/registration/pose_belief.hpp"

namespace ribbon_mapper {

/// The lines between two corrected poses, chained to these and to each other by the odometry: a
/// bridge of a random walk. (Before the first and after the last corrected pose one end is loose.)
///
/// What the lines observe is taken in by sweeps to and fro (Rauch, Tung, Striebel 1965 in its form
/// of two filters): each line is looked at where all the others and both ends say it is, so
/// certainty grows from the ends inwards, and what a ribbon may be is asked when it is known best.
class Bridge {
 public:
  /// Poses of a line: as they are believed to be without what the line itself observes.
  using Observe = std::function<Observation(std::size_t line, const PoseBelief& without_it)>;

  /// `steps` of the odometry: from the first end to the first line, to the next, .., to the second
  /// end; at least two. At least one end is known.
  Bridge(const std::vector<Pose>& steps, const OdometryNoise& noise,
         const std::optional<Pose>& first_end, const std::optional<Pose>& second_end);

  std::size_t lines() const { return ahead_.size(); }

  /// What odometry and ends say alone, or after sweep() all that the other lines say, too.
  PoseBelief without(std::size_t line) const { return fused(ahead_[line], behind_[line]); }

  /// Once forth and back.
  void sweep(const Observe& observe);

 private:
  void forth(const Observe* observe);
  void back(const Observe* observe);

  PoseBelief first_end_, second_end_;
  std::vector<Pose> steps_;         // from each to the next, one more than lines
  std::vector<Vector6> variances_;  // of the steps
  // Of each line, from all that lies before it, and from all that lies behind it.
  std::vector<PoseBelief> ahead_, behind_;
};

}  // namespace ribbon_mapper
