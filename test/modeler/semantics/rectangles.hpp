// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::rectangles {

/// Returns a plane over the rectangle of `u` and `v` from `corner`, with all its cells. Its normal
/// is that of u x v; `u` is level.
inline Plane rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                       const Eigen::Vector3d& v, std::int64_t id = 0) {
  Plane plane;
  plane.id = id;
  plane.normal = u.cross(v).normalized();
  plane.d_m = -plane.normal.dot(corner);
  plane.origin = corner;
  plane.axis_u = u.normalized();
  plane.axis_v = plane.normal.cross(plane.axis_u);
  plane.area_m2 = u.norm() * v.norm();
  plane.centroid = corner + 0.5 * (u + v);
  const auto columns = static_cast<std::int32_t>(std::lround(u.norm() / plane.cell_size_m));
  const auto rows = static_cast<std::int32_t>(std::lround(v.norm() / plane.cell_size_m));
  for (std::int32_t row = 0; row < rows; ++row) {
    for (std::int32_t column = 0; column < columns; ++column) {
      plane.cells.push_back({column, row, 1, 0.0F, 0.0F});
    }
  }
  return plane;
}

/// Returns a level rectangle seen from above.
inline Plane level(double x, double y, double z, double width, double depth, std::int64_t id = 0) {
  return rectangle({x, y, z}, {width, 0, 0}, {0, depth, 0}, id);
}

/// Returns a level rectangle seen from below.
inline Plane level_down(double x, double y, double z, double width, double depth,
                        std::int64_t id = 0) {
  return rectangle({x, y + depth, z}, {width, 0, 0}, {0, -depth, 0}, id);
}

/// Returns an upright rectangle at `y` from `x` on, seen from smaller y.
inline Plane upright(double x, double y, double width, double bottom, double top,
                     std::int64_t id = 0) {
  return rectangle({x, y, bottom}, {width, 0, 0}, {0, 0, top - bottom}, id);
}

/// Returns a plane without the cells whose centre is in a box.
inline Plane without(Plane plane, const Eigen::AlignedBox3d& box) {
  std::vector<PlaneCell> kept;
  for (const PlaneCell& cell : plane.cells) {
    if (!box.contains(cell_centre(plane, cell))) kept.push_back(cell);
  }
  plane.area_m2 *= static_cast<double>(kept.size()) / static_cast<double>(plane.cells.size());
  plane.cells = kept;
  return plane;
}

}  // namespace ribbon_mapper::rectangles
