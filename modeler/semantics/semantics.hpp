// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/semantics/door_openings.hpp"
#include "modeler/semantics/label.hpp"
#include "modeler/semantics/label_config.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What the planes of a model are.
struct Semantics {
  std::vector<Decision> labels;       ///< of the planes, in their order
  std::vector<DoorOpening> openings;  ///< in walls: those that are passable or have a leaf
};

/// Labels the planes of a model by rules about their shape and place; docs/labels.md lists the
/// rules. The z axis of map is up (REP 103).
///
/// `driven` are positions of the robot's footprint in map [m], where the floor is; there may be
/// none. The planes need their cells: one without cells is furniture with confidence 0.
Semantics semantics_of(const std::vector<Plane>& planes, const std::vector<Eigen::Vector3d>& driven,
                       const LabelConfig& config = {});

/// Returns the positions of a trajectory of the robot's footprint.
std::vector<Eigen::Vector3d> positions_of(const std::vector<StampedPose>& trajectory);

}  // namespace ribbon_mapper
