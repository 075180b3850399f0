// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/semantics/door_openings.hpp"
#include "modeler/semantics/label.hpp"
#include "modeler/semantics/scene.hpp"

namespace ribbon_mapper {

/// Decides whether an upright plane is a wall or furniture.
Decision wall_or_furniture(std::size_t plane, const Scene& scene);

/// Returns the openings at a jamb of which an upright plane hangs by an edge, if it has the size of
/// a door leaf. They are indices: both sides of a wall have one.
std::vector<std::size_t> openings_of_leaf(std::size_t plane,
                                          const std::vector<DoorOpening>& openings,
                                          const Scene& scene);

/// Returns true if an upright plane is the inside of a door opening: across its wall, at a jamb, no
/// deeper than a wall.
bool is_reveal(std::size_t plane, const std::vector<DoorOpening>& openings, const Scene& scene);

}  // namespace ribbon_mapper
