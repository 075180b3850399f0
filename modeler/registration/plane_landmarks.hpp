// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "modeler/association/hypothesis.hpp"
#include "modeler/association/voxel_index.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/registration/line_state.hpp"
#include "modeler/registration/plane_adjustment.hpp"
#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/pose_belief.hpp"
#include "modeler/registration/registration_config.hpp"

namespace ribbon_mapper {

/// Returns the planes of localised lines' ribbons that have independent support: min_ribbons
/// ribbons more than the one segment contributes that contributes the most. What a single segment
/// has seen may be that segment's error. `lines` holds the state of each pose of `observations`.
std::vector<Hypothesis> supported_planes(const PosedObservations& observations,
                                         const std::vector<LineState>& lines,
                                         const RegistrationConfig& config,
                                         const SharedSettings& shared);

/// Matches the ribbons of a line with landmarks.
class LandmarkMatcher {
 public:
  /// Refers to landmarks, which must outlive this.
  LandmarkMatcher(const std::vector<PlaneLandmark>& landmarks, const RegistrationConfig& config)
      : landmarks_(&landmarks), config_(config) {}

  /// Measures the pose of a line by matching its ribbons. `without_them` is the belief of that
  /// pose without these ribbons. Ribbons are matched to their candidates, and a second time from
  /// where the first match places the line.
  PoseInformation measure(const std::vector<PlaneObservation>& observations,
                          const PoseBelief& without_them) const;

  /// Returns the matches of a line's ribbons, seen from the believed pose. Ribbons without a match
  /// or with an ambiguous one are left out. The matches point into `observations`.
  std::vector<LandmarkMatch> matches(const std::vector<PlaneObservation>& observations,
                                     const PoseBelief& belief) const;

  /// Returns true if a ribbon, seen from the believed pose, lies at a candidate and faces its side,
  /// however it is tilted and whatever else it lies at.
  bool lies_at_candidate(const PlaneObservation& observation, const PoseBelief& belief) const;

 private:
  struct Match {
    std::uint32_t landmark;
    double square_sigmas;  // of the innovation
    Eigen::Vector2d residual;
  };
  double square_sigmas_across(const PlaneObservation& observation, const Eigen::Vector3d& normal,
                              const PoseBelief& belief) const;
  std::optional<Match> match_of(const PlaneObservation& observation,
                                const PoseBelief& belief) const;
  PoseInformation linearised(const std::vector<PlaneObservation>& observations,
                             const PoseBelief& belief) const;

  const std::vector<PlaneLandmark>* landmarks_;
  RegistrationConfig config_;
};

/// Returns a plane as a landmark.
PlaneLandmark landmark_of(const Hypothesis& plane);

/// The planes that ribbons are registered to, and the matching of ribbons with them.
class PlaneLandmarks {
 public:
  /// Creates landmarks from planes: each has the index of its plane. `ribbon_at` returns the member
  /// of an index in the frame of the planes. Ribbons are near a landmark within `reach_m` of its
  /// members.
  PlaneLandmarks(const std::vector<Hypothesis>& planes,
                 const std::function<PosedRibbon(std::uint32_t)>& ribbon_at, double reach_m,
                 const RegistrationConfig& config);

  /// Returns the indices of the landmarks that a ribbon nearly touches.
  std::vector<std::uint32_t> landmarks_near(const PosedRibbon& ribbon);

  /// Matches as LandmarkMatcher::measure() does.
  PoseInformation measure(const std::vector<PlaneObservation>& observations,
                          const PoseBelief& without_them) const {
    return LandmarkMatcher(landmarks_, config_).measure(observations, without_them);
  }
  /// Matches as LandmarkMatcher::matches() does.
  std::vector<LandmarkMatch> matches(const std::vector<PlaneObservation>& observations,
                                     const PoseBelief& belief) const {
    return LandmarkMatcher(landmarks_, config_).matches(observations, belief);
  }
  /// Tells the same as LandmarkMatcher::lies_at_candidate().
  bool lies_at_candidate(const PlaneObservation& observation, const PoseBelief& belief) const {
    return LandmarkMatcher(landmarks_, config_).lies_at_candidate(observation, belief);
  }

  /// Lets a landmark be found near another ribbon of its plane.
  void extend(std::uint32_t landmark, const PosedRibbon& ribbon);

  /// Returns all landmarks by index.
  const std::vector<PlaneLandmark>& all() const { return landmarks_; }

 private:
  void add(const Hypothesis& plane, const std::function<PosedRibbon(std::uint32_t)>& ribbon_at);
  RegistrationConfig config_;
  std::vector<PlaneLandmark> landmarks_;
  VoxelIndex index_;
  std::vector<std::uint32_t> voxels_;  // scratch
};

}  // namespace ribbon_mapper
