// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/pose_belief.hpp"
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {

/// An observation and the landmark that it was matched to.
struct LandmarkMatch {
  const PlaneObservation* observation = nullptr;  ///< not owned
  std::uint32_t landmark = 0;                     ///< index
};

/// The pose of a line and what was matched from there.
struct ObservingLine {
  Pose T_model_base = Pose::Identity();  ///< estimated so far
  std::vector<LandmarkMatch> matches;    ///< of the line's ribbons
};

/// A segment in the model frame with its lines.
struct ObservingSegment {
  TrajectorySegment segment;         ///< with step variances and at least one known end
  std::vector<ObservingLine> lines;  ///< one for each line of the segment
  /// Information of the steps' errors, along the axes of the base before the step, in place of the
  /// segment's step variances; empty: these count.
  std::vector<Matrix6> step_information{};
};

/// Adjusts landmarks and poses of segments together by one Gauss-Newton step. It minimises the
/// distances and tilts of all matched ribbons and the errors of all odometry steps.
///
/// Estimated in turn, both would hardly move: lines hold on to the landmarks, and these to their
/// lines. Poses are eliminated segment by segment (Schur complement), which leaves a dense system
/// of three unknowns per landmark. The poses of `known_lines` are taken as exact. Residuals have
/// half their weight at `robust_sigmas`, see RegistrationConfig.
void adjust(const std::vector<ObservingLine>& known_lines, std::vector<ObservingSegment>& segments,
            std::vector<PlaneLandmark>& landmarks, double robust_sigmas);

/// Returns the covariances of the poses' errors where they are, by segment and line: what adjust()
/// would leave of them. No step is taken. They are those of the weighted least squares.
std::vector<Matrix6> pose_covariances(const std::vector<ObservingLine>& known_lines,
                                      const std::vector<ObservingSegment>& segments,
                                      const std::vector<PlaneLandmark>& landmarks,
                                      double robust_sigmas);

}  // namespace ribbon_mapper
