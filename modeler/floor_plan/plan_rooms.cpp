// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/plan_rooms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "modeler/polygon/polygon_operations.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kSameShare = 0.5;  // of a room's free floor that its walls must enclose
constexpr double kAside_m = 0.3;    // from the face of a wall to the room before it

/// Returns the rectangle on a line from a to b, from `begin_m` to `end_m` along `across`.
Polygon strip(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& across,
              double begin_m, double end_m) {
  Polygon polygon{
      {a + begin_m * across, b + begin_m * across, b + end_m * across, a + end_m * across}, {}};
  if (signed_area(polygon.outer) < 0.0) std::reverse(polygon.outer.begin(), polygon.outer.end());
  return polygon;
}

/// Returns how far a wall that ends at a point, going in a direction, is from what it ends before:
/// nothing if it ends there, or if there is nothing near.
std::optional<double> gap_before_m(const Eigen::Vector2d& end, const Eigen::Vector2d& direction,
                                   const Polygons& barriers, double reach_m) {
  constexpr double kStep_m = 0.02;
  for (double ahead_m = kStep_m; ahead_m <= reach_m; ahead_m += kStep_m) {
    if (distance(barriers, end + ahead_m * direction) > 0.0) continue;
    if (ahead_m == kStep_m) return std::nullopt;
    return ahead_m;
  }
  return std::nullopt;
}

/// Returns strips that lengthen walls as far as the next one, where less than a door is missing:
/// something hides the wall there.
std::vector<Polygon> bridges_between(const std::vector<PlanWall>& walls, const Polygons& barriers,
                                     const FloorPlanConfig& config) {
  std::vector<Polygon> bridges;
  for (const PlanWall& wall : walls) {
    const Eigen::Vector2d along = (wall.face[1] - wall.face[0]).normalized();
    const double depth_m = wall.thickness_m.value_or(config.unseen_depth_m);
    for (const auto& [end, direction] :
         {std::pair(wall.face[0], Eigen::Vector2d(-along)), std::pair(wall.face[1], along)}) {
      const Eigen::Vector2d inside = end - 0.5 * depth_m * wall.normal;
      const auto gap_m = gap_before_m(inside, direction, barriers, config.bridged_m);
      if (gap_m)
        bridges.push_back(strip(end, end + *gap_m * direction, wall.normal, -depth_m, 0.0));
    }
  }
  return bridges;
}

/// Returns what bounds rooms: walls, and openings as if they were shut.
Polygons barriers(const std::vector<PlanWall>& walls, const std::vector<PlanOpening>& openings,
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
  const std::vector<Polygon> bridges = bridges_between(walls, all, config);
  all.insert(all.end(), bridges.begin(), bridges.end());
  return all.empty() ? all : grown(all, 0.0);
}

/// Returns the parts of the plane between the barriers; the first one is all that is around.
std::vector<Polygon> enclosures(const Polygons& barriers, const FloorPlanConfig& config) {
  Eigen::AlignedBox2d box;
  for (const Polygon& barrier : barriers) {
    for (const Eigen::Vector2d& point : barrier.outer) box.extend(point);
  }
  if (box.isEmpty()) return {};
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(1.0);
  const Eigen::Vector2d low = box.min() - margin, high = box.max() + margin;
  const Polygons all{{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}};
  const Polygons between = difference(all, barriers);
  std::vector<Polygon> parts;
  for (const Polygon& core : grown(between, -config.joint_m)) {
    const bool is_around = distance({core}, low) <= 2.0 * config.joint_m;
    if (is_around) continue;
    Polygons part = intersection(grown({core}, config.joint_m), between);
    const auto largest =
        std::max_element(part.begin(), part.end(),
                         [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
    if (largest != part.end()) parts.push_back(*largest);
  }
  return parts;
}

/// Returns the index of the part that holds most of a room's free floor.
std::optional<std::size_t> enclosure_of(const Room& room, const std::vector<Polygon>& parts) {
  std::optional<std::size_t> best;
  double most_m2 = kSameShare * area(room.outlines);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (area(parts[i]) < most_m2) continue;
    const double common_m2 = area(intersection({parts[i]}, room.outlines));
    if (common_m2 > most_m2) most_m2 = common_m2, best = i;
  }
  return best;
}

PlanRoom plan_room(const Room& room, const Polygon* enclosure) {
  PlanRoom result;
  result.free_floor_m2 = room.area_m2;
  result.is_enclosed = enclosure != nullptr;
  result.outline = enclosure != nullptr ? simplified({*enclosure}, 0.01) : room.outlines;
  result.area_m2 = enclosure != nullptr ? area(result.outline) : room.area_m2;
  result.middle =
      result.outline.empty() ? room.centre.head<2>() : middle_of_largest_circle(result.outline);
  return result;
}

}  // namespace

std::vector<PlanRoom> plan_rooms(const Rooms& rooms, const std::vector<PlanWall>& walls,
                                 const std::vector<PlanOpening>& openings,
                                 const FloorPlanConfig& config) {
  if (rooms.rooms.empty()) return {};
  const std::vector<Polygon> parts = enclosures(barriers(walls, openings, config), config);
  std::vector<std::optional<std::size_t>> own;
  std::vector<std::size_t> users(parts.size());
  for (const Room& room : rooms.rooms) {
    own.push_back(enclosure_of(room, parts));
    if (own.back()) ++users[*own.back()];
  }
  std::vector<PlanRoom> result;
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    const bool is_enclosed = own[i] && users[*own[i]] == 1;
    result.push_back(plan_room(rooms.rooms[i], is_enclosed ? &parts[*own[i]] : nullptr));
  }
  return result;
}

void connect(const std::vector<PlanRoom>& rooms, const FloorPlanConfig& config,
             std::vector<PlanOpening>& openings) {
  for (PlanOpening& opening : openings) {
    const double aside_m =
        kAside_m + (opening.depth_m ? 0.5 * *opening.depth_m : config.greatest_thickness_m);
    for (const double side_m : {kAside_m + 0.5 * opening.depth_m.value_or(0.0), -aside_m}) {
      const Eigen::Vector2d place = opening.middle() + side_m * opening.normal;
      for (std::size_t i = 0; i < rooms.size(); ++i) {
        if (distance(rooms[i].outline, place) > 0.0) continue;
        opening.rooms.push_back(i);
        break;
      }
    }
    std::sort(opening.rooms.begin(), opening.rooms.end());
    opening.rooms.erase(std::unique(opening.rooms.begin(), opening.rooms.end()),
                        opening.rooms.end());
  }
}

}  // namespace ribbon_mapper
