// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/scale/office.hpp"

#include <cstdio>
#include <string>

#include "modeler/storage/atomic_file.hpp"
#include "modeler/storage/disk.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr double kWidth_m = 5.0, kDepth_m = 4.0, kCorridor_m = 2.4, kHeight_m = 2.8;
constexpr double kWall_m = 0.1, kDoor_m = 1.1, kDoorHeight_m = 2.1;

/// An office floor in SDF.
class Building {
 public:
  /// Adds a box by its centre and size [m].
  void box(double x, double y, double z, double sx, double sy, double sz) {
    char text[320];
    std::snprintf(text, sizeof text,
                  "<collision name='box_%d'><pose>%.3f %.3f %.3f 0 0 0</pose>"
                  "<geometry><box><size>%.3f %.3f %.3f</size></box></geometry></collision>\n",
                  count_++, x, y, z, sx, sy, sz);
    text_ += text;
  }
  /// Adds a wall from the floor to the ceiling.
  void wall(double x, double y, double sx, double sy) {
    box(x, y, kHeight_m / 2.0, sx, sy, kHeight_m);
  }
  /// Adds the wall between a room and the corridor, with a doorway in its middle.
  void wall_with_door(double x, double y) {
    const double part_m = (kWidth_m - kDoor_m) / 2.0, lintel_m = kHeight_m - kDoorHeight_m;
    for (const double side : {-1.0, 1.0}) {
      wall(x + side * (kDoor_m + part_m) / 2.0, y, part_m, kWall_m);
    }
    box(x, y, kHeight_m - lintel_m / 2.0, kDoor_m, kWall_m, lintel_m);
  }
  /// Adds a room with furniture at shifted places; `side` is 1 left of the corridor, -1 right of
  /// it.
  void room(int column, double side) {
    const double x = (column + 0.5) * kWidth_m, door_y = side * kCorridor_m / 2.0;
    const double back_y = door_y + side * kDepth_m;
    wall_with_door(x, door_y);
    wall(x, back_y, kWidth_m, kWall_m);
    wall(x + kWidth_m / 2.0, (door_y + back_y) / 2.0, kWall_m, kDepth_m);
    const double shift_m = 0.1 * (column % 7);
    box(x - 1.6, back_y - side * (0.9 + shift_m), 0.72, 1.4, 0.8, 0.05);  // table
    box(x + 2.1, back_y - side * 0.9, 0.9, 0.5, 1.2, 1.8);                // cupboard
    box(x + 1.0 - shift_m, back_y - side * 0.3, 0.4, 0.8, 0.4, 0.8);      // chest of drawers
  }
  std::string sdf() const {
    return "<?xml version='1.0'?>\n<sdf version='1.6'><world name='office'>\n"
           "<model name='office'><static>true</static><link name='link'>\n" +
           text_ + "</link></model></world></sdf>\n";
  }

 private:
  std::string text_;
  int count_ = 0;
};

std::string world_of(int columns) {
  const double length_m = columns * kWidth_m, across_m = kCorridor_m + 2.0 * kDepth_m;
  Building building;
  building.box(length_m / 2.0, 0.0, -0.05, length_m + 1.0, across_m + 1.0, 0.1);
  building.box(length_m / 2.0, 0.0, kHeight_m + 0.05, length_m + 1.0, across_m + 1.0, 0.1);
  building.wall(0.0, 0.0, kWall_m, across_m);
  building.wall(length_m, 0.0, kWall_m, kCorridor_m);
  for (int column = 0; column < columns; ++column) {
    for (const double side : {1.0, -1.0}) building.room(column, side);
  }
  return building.sdf();
}

std::string route_of(int columns) {
  std::string text = "speed: 0.8\nturn_rate: 1.0\nwaypoints:\n";
  const auto go = [&text](double x, double y) {
    char line[64];
    std::snprintf(line, sizeof line, "  - [%.2f, %.2f]\n", x, y);
    text += line;
  };
  go(1.0, 0.0);
  for (int column = 0; column < columns; ++column) {
    const double x = (column + 0.5) * kWidth_m;
    for (const double y : {0.0, 2.7, 0.0, -2.7, 0.0}) go(x, y);
  }
  go(1.0, 0.0);
  return text;
}

}  // namespace

TourSource office_tour(int rooms, const std::filesystem::path& directory) {
  TourSource source;
  source.name = "office_" + std::to_string(rooms);
  source.world = directory / (source.name + ".sdf");
  source.route = directory / (source.name + ".route.yaml");
  create_directory_for_files(directory);
  write_file_atomically(source.world, world_of(rooms / 2));
  write_file_atomically(source.route, route_of(rooms / 2));
  return source;
}

}  // namespace ribbon_mapper::bench
