// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/plan_openings.hpp"
#include "modeler/floor_plan/plan_walls.hpp"

namespace ribbon_mapper {

/// Returns the rectangle on a line from a to b, from `begin_m` to `end_m` along `across`.
Polygon strip(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& across,
              double begin_m, double end_m);

/// Returns what bounds rooms: walls, and openings as if they were shut. A wall of which one face
/// was seen is FloorPlanConfig::unseen_depth_m deep.
Polygons barriers_of(const std::vector<PlanWall>& walls, const std::vector<PlanOpening>& openings,
                     const FloorPlanConfig& config);

/// Returns strips that lengthen walls as far as the next barrier, where furniture seems to hide
/// them: less than a door is missing, or nobody has seen the floor go through. `floor` is that of
/// floor_of().
Polygons hidden_walls(const std::vector<PlanWall>& walls, const Polygons& barriers,
                      const Polygons& floor, const FloorPlanConfig& config);

}  // namespace ribbon_mapper
