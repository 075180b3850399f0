// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/floor_plan.hpp"

#include "modeler/floor_plan/hidden_walls.hpp"
#include "modeler/polygon/polygon_operations.hpp"

namespace ribbon_mapper {

FloorPlan floor_plan_of(const std::vector<Plane>& planes, const Semantics& semantics,
                        const Rooms& rooms, const FloorPlanConfig& config) {
  FloorPlan plan;
  const Polygons floor = floor_of(planes, semantics);
  std::vector<WallFace> faces = wall_faces(planes, semantics, floor, config);
  fit_corners(faces, config);
  plan.openings = plan_openings(planes, semantics, faces, config);
  plan.walls = plan_walls(faces, config);
  plan.solid = solid_of(plan.walls, config);
  const Polygons barriers = barriers_of(plan.walls, plan.openings, config);
  plan.hidden = hidden_walls(plan.walls, barriers, floor, config);
  plan.rooms = plan_rooms(rooms, united(barriers, plan.hidden), config);
  connect(plan.rooms, config, plan.openings);
  return plan;
}

}  // namespace ribbon_mapper
