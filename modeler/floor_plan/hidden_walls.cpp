// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/hidden_walls.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/polygon/prepared_area.hpp"

namespace ribbon_mapper {
namespace {

/// Returns how far a wall that ends at a point, going in a direction, is from what it ends before:
/// nothing if it ends there, or if there is nothing near.
std::optional<double> gap_before_m(const Eigen::Vector2d& end, const Eigen::Vector2d& direction,
                                   const PreparedArea& barriers, double reach_m) {
  constexpr double kStep_m = 0.025;
  for (double ahead_m = kStep_m; ahead_m <= reach_m; ahead_m += kStep_m) {
    if (!barriers.holds(end + ahead_m * direction)) continue;
    if (ahead_m == kStep_m) return std::nullopt;
    return ahead_m;
  }
  return std::nullopt;
}

bool is_hidden(const Polygon& gap, double length_m, const Polygons& floor,
               const FloorPlanConfig& config) {
  if (length_m <= config.bridged_m) return true;
  return area(intersection({gap}, floor)) < config.through_share * area(gap);
}

}  // namespace

Polygon strip(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& across,
              double begin_m, double end_m) {
  Polygon polygon{
      {a + begin_m * across, b + begin_m * across, b + end_m * across, a + end_m * across}, {}};
  if (signed_area(polygon.outer) < 0.0) std::reverse(polygon.outer.begin(), polygon.outer.end());
  return polygon;
}

Polygons barriers_of(const std::vector<PlanWall>& walls, const std::vector<PlanOpening>& openings,
                     const FloorPlanConfig& config) {
  Polygons all = solid_of(walls, config);
  for (const PlanWall& wall : walls) {
    if (wall.thickness_m) continue;
    all.push_back(strip(wall.face[0], wall.face[1], wall.normal, -config.unseen_depth_m, 0.0));
  }
  for (const PlanOpening& opening : openings) {
    const double half_m = 0.5 * opening.depth_m.value_or(config.unseen_depth_m);
    const double ahead_m = opening.depth_m ? half_m : 0.0;
    all.push_back(
        strip(opening.jambs[0], opening.jambs[1], opening.normal, ahead_m - 2.0 * half_m, ahead_m));
  }
  return all.empty() ? all : grown(all, 0.0);
}

Polygons hidden_walls(const std::vector<PlanWall>& walls, const Polygons& barriers,
                      const Polygons& floor, const FloorPlanConfig& config) {
  Polygons hidden;
  const PreparedArea before(barriers);
  for (const PlanWall& wall : walls) {
    const Eigen::Vector2d along = (wall.face[1] - wall.face[0]).normalized();
    const double depth_m = wall.thickness_m.value_or(config.unseen_depth_m);
    for (const auto& [end, direction] :
         {std::pair(wall.face[0], Eigen::Vector2d(-along)), std::pair(wall.face[1], along)}) {
      const Eigen::Vector2d inside = end - 0.5 * depth_m * wall.normal;
      const auto gap_m = gap_before_m(inside, direction, before, config.hidden_m);
      if (!gap_m) continue;
      const Polygon gap = strip(end, end + *gap_m * direction, wall.normal, -depth_m, 0.0);
      if (is_hidden(gap, *gap_m, floor, config)) hidden.push_back(gap);
    }
  }
  return hidden.empty() ? hidden : difference(grown(hidden, 0.0), barriers);
}

}  // namespace ribbon_mapper
