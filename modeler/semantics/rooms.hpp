// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "modeler/polygon/polygon.hpp"
#include "modeler/semantics/semantics.hpp"

namespace ribbon_mapper {

/// How the floor is divided into rooms.
struct RoomConfig {
  /// Least area of a room [m2]. A lavatory has one; the floor between the jambs of a door has less.
  double least_area_m2 = 1.0;

  /// Side of the squares in which the floor is divided [m].
  double square_m = 0.05;

  /// Thickness of a wall of which one side was seen [m]. Less than the thinnest, and two squares.
  double wall_m = 0.08;

  /// Largest distance of a room's floor from a door opening [m]: the depth of a wall.
  double door_depth_m = 0.6;
};

/// A part of the free floor that walls and door openings bound.
struct Room {
  double area_m2 = 0.0;                              ///< of the free floor
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the largest circle on it, in map [m]
  Polygons outlines;                                 ///< seen from above, in map [m]
};

/// A door opening between two rooms.
struct Passage {
  std::array<std::size_t, 2> rooms = {};  ///< indices of the rooms, the smaller first
  DoorOpening opening;                    ///< the opening, on one side of the wall
};

/// The rooms of a model, and how one gets from one to another.
struct Rooms {
  std::vector<Room> rooms;        ///< the largest first
  std::vector<Passage> passages;  ///< each once, though both sides of its wall were seen
};

/// Returns the name of a room by its index: A to Z, then AA and so on.
std::string room_name(std::size_t index);

/// Returns the outlines of a room's floor in map, at the height of its centre.
std::vector<Outline> floor_outlines(const Room& room);

/// Divides the free floor of a model into rooms, at walls and door openings. `semantics` are those
/// of the planes. Furniture and what was not seen is no free floor; stripes between scan lines of
/// up to `stripe_gap_m` are, see SurfaceConfig::stripe_gap_m.
Rooms rooms_of(const std::vector<Plane>& planes, const Semantics& semantics, double stripe_gap_m,
               const RoomConfig& config = {});

}  // namespace ribbon_mapper
