// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/plane.hpp"

#include "modeler/surface/cell_bitmap.hpp"

namespace ribbon_mapper {

std::vector<CellRectangle> surface_rectangles(const Plane& plane, double stripe_gap_m) {
  if (plane.cells.empty()) return {};
  CellBitmap bitmap(plane.cells, static_cast<int>(0.5 * stripe_gap_m / plane.cell_size_m));
  bitmap.close();
  return bitmap.rectangles();
}

}  // namespace ribbon_mapper
