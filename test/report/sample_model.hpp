// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Sets outline and cells of a plane to a rectangle of columns x rows cells of 5 cm.
inline Plane rectangle(Plane plane, int columns, int rows) {
  plane.axis_v = plane.normal.cross(plane.axis_u);
  plane.d_m = -plane.normal.dot(plane.origin);
  plane.area_m2 = columns * rows * plane.cell_size_m * plane.cell_size_m;
  plane.centroid = (grid_corner(plane, 0, 0) + grid_corner(plane, columns, rows)) / 2.0;
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      plane.cells.push_back({u, v, 2, 0.001F * static_cast<float>(u % 7 - 3), 0.0F});
    }
  }
  plane.outlines = {{{grid_corner(plane, 0, 0), grid_corner(plane, columns, 0),
                      grid_corner(plane, columns, rows), grid_corner(plane, 0, rows)},
                     {}}};
  return plane;
}

/// Returns a floor of 6 m x 4 m at z = 0, from (0, 0) on.
inline Plane sample_floor() {
  Plane plane;
  plane.id = 1;
  return rectangle(plane, 120, 80);
}

/// Returns a wall of 6 m x 2.5 m at y = `y_m` that was seen from smaller y, with a door of
/// 1 m x 2 m from x = 2 m on.
inline Plane sample_wall(std::int64_t id, double y_m) {
  Plane plane;
  plane.id = id;
  plane.normal = -Eigen::Vector3d::UnitY();
  plane.axis_u = Eigen::Vector3d::UnitX();
  plane.origin = {0.0, y_m, 0.0};
  plane = rectangle(plane, 120, 50);
  const auto is_in_door = [](const PlaneCell& c) { return c.u >= 40 && c.u < 60 && c.v < 40; };
  std::vector<PlaneCell> seen;
  for (const PlaneCell& cell : plane.cells) {
    if (!is_in_door(cell)) seen.push_back(cell);
  }
  plane.cells = seen;
  plane.area_m2 = 13.0;
  auto& outer = plane.outlines.front().outer;
  outer.insert(outer.begin() + 1, {grid_corner(plane, 40, 0), grid_corner(plane, 40, 40),
                                   grid_corner(plane, 60, 40), grid_corner(plane, 60, 0)});
  return plane;
}

/// Returns a ceiling above the floor, seen from below.
inline Plane sample_ceiling() {
  Plane plane;
  plane.id = 3;
  plane.normal = -Eigen::Vector3d::UnitZ();
  plane.axis_u = -Eigen::Vector3d::UnitX();
  plane.origin = {6.0, 0.0, 2.5};
  return rectangle(plane, 120, 80);
}

/// Returns a table of 2 m x 1 m at z = 0.7 m with a hole of 1 m x 0.5 m.
inline Plane sample_table() {
  Plane plane;
  plane.id = 4;
  plane.origin = {3.0, 1.0, 0.7};
  plane = rectangle(plane, 40, 20);
  plane.outlines.front().holes = {{grid_corner(plane, 10, 5), grid_corner(plane, 10, 15),
                                   grid_corner(plane, 30, 15), grid_corner(plane, 30, 5)}};
  return plane;
}

/// Returns `count` poses along x, a second apart, at y = `y_m`.
inline std::vector<StampedPose> sample_path(std::size_t count, double y_m) {
  std::vector<StampedPose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const auto second = static_cast<std::int64_t>(i);
    const double x_m = 0.5 + 5.0 * static_cast<double>(i) / static_cast<double>(count);
    poses.push_back(
        {Time(1'700'000'000'000'000'000 + second * 1'000'000'000), planar_pose(x_m, y_m, 0.0)});
  }
  return poses;
}

}  // namespace ribbon_mapper
