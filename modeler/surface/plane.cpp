// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/plane.hpp"

#include <algorithm>

#include "modeler/surface/cell_bitmap.hpp"

namespace ribbon_mapper {

std::vector<std::int32_t> planes_by_ribbon(std::size_t count, const std::vector<Plane>& planes) {
  std::vector<std::int32_t> result(count, -1);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (const std::uint32_t ribbon : planes[i].ribbons) {
      result[ribbon] = static_cast<std::int32_t>(i);
    }
  }
  return result;
}

CellRectangle bounds_of_cells(const Plane& plane) {
  if (plane.cells.empty()) return {};
  const PlaneCell &first = plane.cells.front(), &last = plane.cells.back();
  CellRectangle bounds{first.u, first.u + 1, first.v, last.v + 1};  // sorted by (v, u)
  for (const PlaneCell& cell : plane.cells) {
    bounds.u_begin = std::min(bounds.u_begin, cell.u);
    bounds.u_end = std::max(bounds.u_end, cell.u + 1);
  }
  return bounds;
}

Eigen::AlignedBox3d box_of_cells(const Plane& plane) {
  Eigen::AlignedBox3d box;
  if (plane.cells.empty()) return box;
  const CellRectangle cells = bounds_of_cells(plane);
  for (const int u : {cells.u_begin, cells.u_end}) {
    for (const int v : {cells.v_begin, cells.v_end}) box.extend(grid_corner(plane, u, v));
  }
  return box;
}

std::vector<Eigen::AlignedBox3d> boxes_of_cells(const std::vector<Plane>& planes) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Plane& plane : planes) boxes.push_back(box_of_cells(plane));
  return boxes;
}

std::vector<CellRectangle> surface_rectangles(const Plane& plane, double stripe_gap_m) {
  if (plane.cells.empty()) return {};
  CellBitmap bitmap(plane.cells, static_cast<int>(0.5 * stripe_gap_m / plane.cell_size_m));
  bitmap.close();
  return bitmap.rectangles();
}

}  // namespace ribbon_mapper
