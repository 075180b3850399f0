// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/semantics/scene.hpp"

namespace ribbon_mapper {

/// An opening in a wall as wide as a door, down to the floor.
struct DoorOpening {
  std::int64_t plane = 0;  ///< id of the wall, of the first one if it is between two
  /// Its two edges on the wall at the height of the floor, in map [m].
  std::array<Eigen::Vector3d, 2> jambs = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double sill_m = 0.0;           ///< height of the floor in it
  std::optional<double> head_m;  ///< height of the lintel; nothing if none was seen
  double confidence = 0.0;       ///< as Decision::confidence
  bool is_passable = true;       ///< false: a door leaf or something else stands in it
};

/// Returns the door openings in the walls of a scene, for each wall from one end of it to the
/// other. Walls in one plane that are less than a door apart are one wall. Among them are gaps
/// below a lintel that are not passable: of closed doors, but also where furniture hides a wall.
std::vector<DoorOpening> door_openings_in(const std::vector<bool>& is_wall, const Scene& scene);

}  // namespace ribbon_mapper
