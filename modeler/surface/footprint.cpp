// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/footprint.hpp"

#include <algorithm>

namespace ribbon_mapper {

Footprint::Footprint(const Plane& plane, double reach_m)
    : plane_(&plane), blocks_per_cell_(plane.cell_size_m / reach_m) {
  if (plane.cells.empty()) return;
  mark_cells();
  mark_around();
}

/// Marks the blocks that hold the centre of a cell, with a margin of free blocks around them.
void Footprint::mark_cells() {
  const std::vector<PlaneCell>& cells = plane_->cells;
  const auto block_of = [&](int cell) { return floor_to_int((cell + 0.5) * blocks_per_cell_); };
  int u_first = cells.front().u, u_last = u_first;
  for (const PlaneCell& cell : cells) {
    u_first = std::min(u_first, cell.u), u_last = std::max(u_last, cell.u);
  }
  u0_ = block_of(u_first) - 1, v0_ = block_of(cells.front().v) - 1;  // sorted by (v, u)
  columns_ = block_of(u_last) + 2 - u0_, rows_ = block_of(cells.back().v) + 2 - v0_;
  is_beside_.assign(index(0, rows_), 0);
  std::vector<int> column_of;  // block column of each column of cells
  for (int u = u_first; u <= u_last; ++u) column_of.push_back(block_of(u) - u0_);
  int v = cells.front().v;
  char* row = &is_beside_[index(0, 1)];
  for (const PlaneCell& cell : cells) {
    if (cell.v != v) v = cell.v, row = &is_beside_[index(0, block_of(v) - v0_)];
    row[column_of[static_cast<std::size_t>(cell.u - u_first)]] = 1;
  }
}

/// Marks the eight neighbours of each marked block, too: first along rows, then along columns.
void Footprint::mark_around() {
  for (const std::size_t step : {index(1, 0), index(0, 1)}) {
    std::vector<char>& beside = is_beside_;
    for (std::size_t i = beside.size() - 1; i >= step; --i) beside[i] |= beside[i - step];
    for (std::size_t i = 0; i + step < beside.size(); ++i) beside[i] |= beside[i + step];
  }
}

}  // namespace ribbon_mapper
