// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/association/plane_map.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/registration/plane_adjustment.hpp"
#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/pose_belief.hpp"

namespace ribbon_mapper {

/// Planes that ribbons are registered against.
class ReferencePlanes {
 public:
  /// Of the ribbons whose line `is_placed`, the confirmed planes, not counting those ribbons that
  /// one bridge has given: what its lines alone have seen may be that bridge's error.
  /// `witness`: of each line kSure, or the number of its bridge.
  ReferencePlanes(const PosedObservations& observations, const std::vector<char>& is_placed,
                  const std::vector<std::int32_t>& witness, const ModelerConfig& config);
  static constexpr std::int32_t kSure = -1;

  /// Sets the planes that are near a ribbon.
  void find_near(const PosedRibbon& ribbon, Sight& sight);

  /// What a line's ribbons say about its pose, given where it is believed to be without them.
  Observation observe(const std::vector<Sight>& sights, const PoseBelief& without_them) const;

  /// The planes that a line's ribbons are seen on from there.
  std::vector<PlaneSighting> sightings(const std::vector<Sight>& sights,
                                       const PoseBelief& belief) const;

  const std::vector<SightedPlane>& planes() const { return planes_; }

 private:
  struct Match {
    std::uint32_t plane;
    double square_sigmas;  ///< of the innovation
    Eigen::Vector2d residual;
  };
  static bool is_witnessed(const Hypothesis& hypothesis, const PosedObservations& observations,
                           const std::vector<std::int32_t>& witness, std::size_t min_ribbons);
  void enter(std::uint32_t slot, const Hypothesis& hypothesis,
             const PosedObservations& observations);
  bool fits_across(const Sight& sight, const Eigen::Vector3d& normal,
                   const PoseBelief& belief) const;
  std::optional<Match> match_of(const Sight& sight, const PoseBelief& belief) const;
  Observation linearised(const std::vector<Sight>& sights, const PoseBelief& belief) const;

  double angle_gate_rad_;
  std::vector<SightedPlane> planes_;
  VoxelIndex index_;
  std::vector<std::uint32_t> voxels_;  // scratch
};

}  // namespace ribbon_mapper
