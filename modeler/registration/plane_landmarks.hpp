// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
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

/// The planes that ribbons are registered to, and the matching of ribbons with them.
class PlaneLandmarks {
 public:
  /// Builds planes from the ribbons of localised lines. A plane becomes a landmark if it has
  /// independent support: min_ribbons ribbons more than the one segment contributes that
  /// contributes the most. What a single segment has seen may be that segment's error.
  /// `lines` holds the state of each pose of `observations`.
  PlaneLandmarks(const PosedObservations& observations, const std::vector<LineState>& lines,
                 const RegistrationConfig& config, const SharedSettings& shared);

  /// Returns the indices of the landmarks that a ribbon nearly touches.
  std::vector<std::uint32_t> landmarks_near(const PosedRibbon& ribbon);

  /// Measures the pose of a line by matching its ribbons. `without_them` is the belief of that
  /// pose without these ribbons. Ribbons are matched to their candidates, and a second time from
  /// where the first match places the line.
  PoseInformation measure(const std::vector<PlaneObservation>& observations,
                          const PoseBelief& without_them) const;

  /// Returns the matches of a line's ribbons, seen from the believed pose. Ribbons without a match
  /// or with an ambiguous one are left out. The matches point into `observations`.
  std::vector<LandmarkMatch> matches(const std::vector<PlaneObservation>& observations,
                                     const PoseBelief& belief) const;

  /// Returns all landmarks by index.
  const std::vector<PlaneLandmark>& all() const { return landmarks_; }

 private:
  struct Match {
    std::uint32_t landmark;
    double square_sigmas;  // of the innovation
    Eigen::Vector2d residual;
  };
  void add(const Hypothesis& hypothesis, const PosedObservations& observations);
  bool fits_across(const PlaneObservation& observation, const Eigen::Vector3d& normal,
                   const PoseBelief& belief) const;
  std::optional<Match> match_of(const PlaneObservation& observation,
                                const PoseBelief& belief) const;
  PoseInformation linearised(const std::vector<PlaneObservation>& observations,
                             const PoseBelief& belief) const;

  RegistrationConfig config_;
  std::vector<PlaneLandmark> landmarks_;
  VoxelIndex index_;
  std::vector<std::uint32_t> voxels_;  // scratch
};

}  // namespace ribbon_mapper
