// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/plan_openings.hpp"
#include "modeler/polygon/polygon.hpp"
#include "modeler/semantics/rooms.hpp"

namespace ribbon_mapper {

/// A room, seen from above.
struct PlanRoom {
  double area_m2 = 0.0;        ///< of the outline
  double free_floor_m2 = 0.0;  ///< of what was seen of its floor, without what furniture covers
  bool is_enclosed = false;    ///< its outline is that of its walls; otherwise, of its free floor
  Polygons outline;            ///< in map [m]
  /// Middle of the largest circle in it, for a label; in map [m].
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

/// Returns the rooms, in the order of `rooms`.
///
/// A room reaches from wall to wall, also below furniture, if barriers enclose it: walls, those
/// that are hidden, and openings as if they were shut. Otherwise it is as large as its free floor.
std::vector<PlanRoom> plan_rooms(const Rooms& rooms, const Polygons& barriers,
                                 const FloorPlanConfig& config);

/// Enters in each opening which rooms are beside it.
void connect(const std::vector<PlanRoom>& rooms, const FloorPlanConfig& config,
             std::vector<PlanOpening>& openings);

}  // namespace ribbon_mapper
