// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/registration/plane_observation.hpp"

namespace ribbon_mapper {

/// A line of the trajectory in the course of the registration.
struct LineState {
  StampedPose pose;                            ///< estimated so far
  std::vector<PlaneObservation> observations;  ///< one per ribbon, in the order of the ribbons

  /// True if the pose is known well enough to build landmarks from the line's ribbons.
  bool is_localised = true;

  /// True if the line belongs to a segment that is registered; its pose may change.
  bool is_registered = false;

  /// Index of the segment without whose registration the line would not be localised; none if
  /// odometry and corrected poses suffice.
  std::optional<std::uint32_t> localised_by;
};

}  // namespace ribbon_mapper
