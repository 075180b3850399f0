// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/floor_plan.hpp"

#include "modeler/floor_plan/face_corners.hpp"

namespace ribbon_mapper {

FloorPlan floor_plan_of(const std::vector<Plane>& planes, const Semantics& semantics,
                        const Rooms& rooms, const FloorPlanConfig& config) {
  FloorPlan plan;
  std::vector<WallFace> faces = wall_faces(planes, semantics, config);
  fit_corners(faces, config);
  plan.openings = plan_openings(planes, semantics, faces, config);
  plan.walls = plan_walls(faces, config);
  plan.solid = solid_of(plan.walls, config);
  plan.rooms = plan_rooms(rooms, plan.walls, plan.openings, config);
  connect(plan.rooms, config, plan.openings);
  return plan;
}

}  // namespace ribbon_mapper
