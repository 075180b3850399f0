// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/wall_face.hpp"
#include "modeler/polygon/polygon.hpp"

namespace ribbon_mapper {

/// A wall between two corners or openings, seen from above.
struct PlanWall {
  std::vector<std::int64_t> planes;  ///< ids of its two faces, or of the one that was seen
  /// Ends of its first face, in map [m].
  std::array<Eigen::Vector2d, 2> face = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< of the first face, out of the wall
  std::optional<double> thickness_m;                  ///< nothing if only one face was seen
  /// What it stands on, in map [m]; nothing if only one face was seen. Walls do not overlap.
  Polygons footprint;
};

/// Returns the walls of these faces.
///
/// Two faces make a wall where they look away from each other, no further apart than a wall is
/// thick. Where several faces come into question, the nearest one is taken. At corners and
/// junctions, one face is longer than the other by the thickness of the next wall; the wall then
/// goes on. So it does where one of the two faces was hidden for a while. All else has one face.
std::vector<PlanWall> plan_walls(const std::vector<WallFace>& faces, const FloorPlanConfig& config);

/// Returns the footprints of all walls with two faces, united. Gaps between walls that are narrower
/// than a joint are closed.
Polygons solid_of(const std::vector<PlanWall>& walls, const FloorPlanConfig& config);

}  // namespace ribbon_mapper
