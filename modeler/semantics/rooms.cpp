// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/rooms.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "modeler/geometry/grid_keys.hpp"
#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/semantics/plane_shape.hpp"
#include "modeler/surface/outline.hpp"

namespace ribbon_mapper {
namespace {

constexpr int kWall = -2, kFree = -1;  // otherwise the number of a component

struct Square {
  std::int32_t x, y;
};

std::uint64_t key_of(Square s) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(s.x)) << 32) |
         static_cast<std::uint32_t>(s.y);
}

/// The floor in squares, seen from above.
class FloorMap {
 public:
  explicit FloorMap(const RoomConfig& config) : config_(config) {}

  /// Adds the floor of a plane and its stripes.
  void add_floor(const Plane& plane, double stripe_gap_m) {
    for (const CellRectangle& r : surface_rectangles(plane, stripe_gap_m)) {
      for (std::int32_t v = r.v_begin; v < r.v_end; ++v) {
        for (std::int32_t u = r.u_begin; u < r.u_end; ++u) add_cell(plane, u, v);
      }
    }
  }

  /// Removes the floor in a wall from `a` to `b`, behind its side.
  void add_wall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& behind) {
    const double step_m = 0.5 * config_.square_m, length_m = (b - a).norm();
    for (double along_m = 0.0; along_m <= length_m; along_m += step_m) {
      for (double depth_m = 0.0; depth_m <= config_.wall_m; depth_m += step_m) {
        const Eigen::Vector2d at = a + along_m / std::max(length_m, step_m) * (b - a);
        const auto found = squares_.find(key_of(square_at(at + depth_m * behind)));
        if (found != squares_.end()) found.value().component = kWall;
      }
    }
  }

  /// Divides the free floor into connected components of the least area, the largest first.
  std::vector<std::vector<Square>> divide() {
    std::vector<std::vector<Square>> components;
    for (const Square& seed : order_) {
      if (squares_.at(key_of(seed)).component == kFree) components.push_back(filled(seed));
    }
    const auto is_small = [&](const std::vector<Square>& component) {
      return static_cast<double>(component.size()) * config_.square_m * config_.square_m <
             config_.least_area_m2;
    };
    components.erase(std::remove_if(components.begin(), components.end(), is_small),
                     components.end());
    std::stable_sort(components.begin(), components.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (auto square = squares_.begin(); square != squares_.end(); ++square) {
      square.value().component = kFree;
    }
    for (std::size_t i = 0; i < components.size(); ++i) {
      for (const Square& s : components[i]) squares_.at(key_of(s)).component = static_cast<int>(i);
    }
    return components;
  }

  /// Returns the component at a place, after divide().
  std::optional<std::size_t> component_at(const Eigen::Vector2d& place) const {
    const auto found = squares_.find(key_of(square_at(place)));
    if (found == squares_.end() || found->second.component < 0) return std::nullopt;
    return static_cast<std::size_t>(found->second.component);
  }

  double height_m(Square s) const { return squares_.at(key_of(s)).height_m; }

 private:
  struct Floor {
    double height_m;
    int component = kFree;
  };

  Square square_at(const Eigen::Vector2d& place) const {
    return {floor_to_int(place.x() / config_.square_m), floor_to_int(place.y() / config_.square_m)};
  }

  /// Adds four points of a cell, so that none is left out if the plane's grid is turned.
  void add_cell(const Plane& plane, std::int32_t u, std::int32_t v) {
    for (const double du : {0.25, 0.75}) {
      for (const double dv : {0.25, 0.75}) {
        const Eigen::Vector3d at = plane.origin + (u + du) * plane.cell_size_m * plane.axis_u +
                                   (v + dv) * plane.cell_size_m * plane.axis_v;
        const Square square = square_at(at.head<2>());
        if (squares_.emplace(key_of(square), Floor{at.z()}).second) order_.push_back(square);
      }
    }
  }

  std::vector<Square> filled(Square seed) {
    std::vector<Square> component{seed};
    squares_.at(key_of(seed)).component = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Square at = component[i];
      for (const auto& [dx, dy] :
           {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        const Square next{at.x + dx, at.y + dy};
        const auto found = squares_.find(key_of(next));
        if (found == squares_.end() || found->second.component != kFree) continue;
        found.value().component = 0;
        component.push_back(next);
      }
    }
    return component;
  }

  RoomConfig config_;
  tsl::robin_map<std::uint64_t, Floor, KeyHash> squares_;
  std::vector<Square> order_;  // as they were added, so that nothing depends on hashes
};

Room room_of(const std::vector<Square>& squares, const FloorMap& floor, const RoomConfig& config) {
  Room room;
  Plane plane;
  plane.cell_size_m = config.square_m;
  for (const Square& s : squares) {
    room.centre.z() += floor.height_m(s) / static_cast<double>(squares.size());
    plane.cells.push_back({s.x, s.y, 1, 0.0F, 0.0F});
  }
  std::sort(plane.cells.begin(), plane.cells.end(), [](const PlaneCell& a, const PlaneCell& b) {
    return std::pair(a.v, a.u) < std::pair(b.v, b.u);
  });
  room.area_m2 = static_cast<double>(squares.size()) * config.square_m * config.square_m;
  room.outlines = seen_area(plane, 2.0 * config.square_m, SurfaceConfig{}.outline_tolerance_m);
  if (!room.outlines.empty()) {
    room.centre.head<2>() = inmost_point(room.outlines, config.square_m);
  }
  return room;
}

FloorMap floor_map_of(const std::vector<Plane>& planes, const Semantics& semantics,
                      double stripe_gap_m, const RoomConfig& config) {
  FloorMap floor(config);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Label label = semantics.labels[i].label;
    if (label == Label::floor || (label == Label::slope && planes[i].normal.z() > 0.0)) {
      floor.add_floor(planes[i], stripe_gap_m);
    }
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (semantics.labels[i].label != Label::wall) continue;
    const PlaneShape shape = shape_of(planes[i], {});
    const Eigen::Vector2d behind = -planes[i].normal.head<2>().normalized();
    const Eigen::Vector2d base = (planes[i].d_m + planes[i].normal.z() * shape.lowest_m) /
                                 planes[i].normal.head<2>().norm() *
                                 behind;  // where it stands, if it leans
    floor.add_wall(base + shape.begin_m * shape.along, base + shape.end_m * shape.along, behind);
  }
  for (const DoorOpening& opening : semantics.openings) {
    const Eigen::Vector2d a = opening.jambs[0].head<2>(), b = opening.jambs[1].head<2>();
    const Eigen::Vector2d along = (b - a).normalized();
    floor.add_wall(a, b, {-along.y(), along.x()});
  }
  return floor;
}

/// Returns the first room from the middle of an opening on, to one of its sides.
std::optional<std::size_t> room_beside(const DoorOpening& opening, double side,
                                       const FloorMap& floor, const RoomConfig& config) {
  const Eigen::Vector2d a = opening.jambs[0].head<2>(), b = opening.jambs[1].head<2>();
  const Eigen::Vector2d along = (b - a).normalized(), across(-along.y(), along.x());
  for (double depth_m = 0.0; depth_m <= config.door_depth_m; depth_m += config.square_m) {
    for (const double share : {0.5, 0.3, 0.7}) {
      const auto room = floor.component_at(a + share * (b - a) + side * depth_m * across);
      if (room) return room;
    }
  }
  return std::nullopt;
}

bool is_same_door(const Passage& a, const Passage& b, const RoomConfig& config) {
  const Eigen::Vector3d middle_a = 0.5 * (a.opening.jambs[0] + a.opening.jambs[1]);
  const Eigen::Vector3d middle_b = 0.5 * (b.opening.jambs[0] + b.opening.jambs[1]);
  return a.rooms == b.rooms && (middle_a - middle_b).norm() <= config.door_depth_m;
}

std::vector<Eigen::Vector3d> at_height(const Ring& ring, double z_m) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector2d& point : ring) points.emplace_back(point.x(), point.y(), z_m);
  return points;
}

}  // namespace

std::string room_name(std::size_t index) {
  std::string name;
  for (std::size_t left = index + 1; left > 0; left = (left - 1) / 26) {
    name.insert(name.begin(), static_cast<char>('A' + (left - 1) % 26));
  }
  return name;
}

std::vector<Outline> floor_outlines(const Room& room) {
  std::vector<Outline> outlines;
  for (const Polygon& polygon : room.outlines) {
    outlines.push_back({at_height(polygon.outer, room.centre.z()), {}});
    for (const Ring& hole : polygon.holes) {
      outlines.back().holes.push_back(at_height(hole, room.centre.z()));
    }
  }
  return outlines;
}

Rooms rooms_of(const std::vector<Plane>& planes, const Semantics& semantics, double stripe_gap_m,
               const RoomConfig& config) {
  FloorMap floor = floor_map_of(planes, semantics, stripe_gap_m, config);
  Rooms rooms;
  for (const std::vector<Square>& squares : floor.divide()) {
    rooms.rooms.push_back(room_of(squares, floor, config));
  }
  for (const DoorOpening& opening : semantics.openings) {
    const auto left = room_beside(opening, 1.0, floor, config);
    const auto right = room_beside(opening, -1.0, floor, config);
    if (!left || !right || *left == *right) continue;
    const Passage passage{{std::min(*left, *right), std::max(*left, *right)}, opening};
    const bool is_known =
        std::any_of(rooms.passages.begin(), rooms.passages.end(),
                    [&](const Passage& other) { return is_same_door(passage, other, config); });
    if (!is_known) rooms.passages.push_back(passage);
  }
  return rooms;
}

}  // namespace ribbon_mapper
