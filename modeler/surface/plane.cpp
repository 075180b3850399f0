// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/plane.hpp"

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

std::vector<CellRectangle> surface_rectangles(const Plane& plane, double stripe_gap_m) {
  if (plane.cells.empty()) return {};
  CellBitmap bitmap(plane.cells, static_cast<int>(0.5 * stripe_gap_m / plane.cell_size_m));
  bitmap.close();
  return bitmap.rectangles();
}

}  // namespace ribbon_mapper
