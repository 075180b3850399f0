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

Eigen::AlignedBox2d box_of(const Polygons& polygons) {
  Eigen::AlignedBox2d box;
  for (const Polygon& polygon : polygons) {
    for (const Eigen::Vector2d& point : polygon.outer) box.extend(point);
  }
  return box;
}

/// Returns the parts of the plane between the barriers; the first one is all that is around.
std::vector<Polygon> enclosures(const Polygons& barriers, const FloorPlanConfig& config) {
  const Eigen::AlignedBox2d box = box_of(barriers);
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
  const Eigen::AlignedBox2d box = box_of(room.outlines);
  double most_m2 = kSameShare * area(room.outlines);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!box_of({parts[i]}).intersects(box)) continue;
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

std::vector<PlanRoom> plan_rooms(const Rooms& rooms, const Polygons& barriers,
                                 const FloorPlanConfig& config) {
  if (rooms.rooms.empty()) return {};
  const std::vector<Polygon> parts = enclosures(barriers, config);
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
