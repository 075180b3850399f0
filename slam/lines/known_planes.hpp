// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "modeler/association/plane_map.hpp"
#include "modeler/registration/plane_landmarks.hpp"
#include "slam/lines/estimate_config.hpp"
#include "slam/lines/posed_lines.hpp"

namespace ribbon_mapper::slam {

/// Returns true if a direction is that of a wall's normal: within 17 degrees of level.
inline bool is_of_wall(const Eigen::Vector3d& normal) { return std::abs(normal.z()) < 0.3; }

/// Returns the planes of some lines at their poses: their ribbons are associated in their order.
/// Planes of fewer than RegistrationConfig::min_ribbons ribbons are left out.
std::vector<Hypothesis> planes_of(const PosedLines& lines,
                                  const std::vector<std::uint32_t>& indices,
                                  const AssociationGates& gates, const EstimateSettings& settings);

/// The planes of some lines at their poses, as landmarks for others.
class KnownPlanes {
 public:
  /// Associates the ribbons of lines, in their order. Planes of fewer than
  /// RegistrationConfig::min_ribbons ribbons are no landmarks. `lines` must outlive this.
  KnownPlanes(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
              const AssociationGates& gates, const EstimateSettings& settings);

  /// Returns the landmarks and their matching.
  PlaneLandmarks& landmarks() { return landmarks_; }
  /// Returns the landmarks and their matching.
  const PlaneLandmarks& landmarks() const { return landmarks_; }
  /// Returns the planes, by landmark.
  const std::vector<Hypothesis>& planes() const { return planes_; }

 private:
  std::vector<Hypothesis> planes_;
  PlaneLandmarks landmarks_;
};

}  // namespace ribbon_mapper::slam
