// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/plan_openings.hpp"
#include "modeler/floor_plan/plan_rooms.hpp"
#include "modeler/floor_plan/plan_walls.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/semantics/semantics.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// A model of one storey from above, as an architect draws it. Metres in map.
struct FloorPlan {
  std::vector<PlanWall> walls;        ///< those with two faces first
  Polygons solid;                     ///< footprints of all walls with two faces, united
  Polygons hidden;                    ///< where walls seem to go on behind furniture
  std::vector<PlanOpening> openings;  ///< doors and other openings
  std::vector<PlanRoom> rooms;        ///< in the order of the rooms that were given
};

/// Returns the floor plan of planes. `semantics` and `rooms` are those of the same planes, which
/// need their outlines. A model without walls has none.
FloorPlan floor_plan_of(const std::vector<Plane>& planes, const Semantics& semantics,
                        const Rooms& rooms, const FloorPlanConfig& config = {});

}  // namespace ribbon_mapper
