// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/footprint.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/map/grid_keys.hpp"

namespace ribbon_mapper {

Footprint::Footprint(const Plane& plane, double reach_m)
    : plane_(&plane), blocks_per_m_(1.0 / reach_m) {
  if (plane.cells.empty()) return;
  const double blocks_per_cell = plane.cell_size_m * blocks_per_m_;
  const auto block_of = [&](int cell) { return floor_to_int((cell + 0.5) * blocks_per_cell); };
  int u_first = plane.cells.front().u, u_last = u_first;
  for (const PlaneCell& cell : plane.cells) {
    u_first = std::min(u_first, cell.u), u_last = std::max(u_last, cell.u);
  }
  u0_ = block_of(u_first) - 1, v0_ = block_of(plane.cells.front().v) - 1;  // sorted by (v, u)
  columns_ = block_of(u_last) + 2 - u0_, rows_ = block_of(plane.cells.back().v) + 2 - v0_;
  is_beside_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  int last_u = -1, last_v = -1, row = plane.cells.front().v - 1, v = 0;
  for (const PlaneCell& cell : plane.cells) {
    if (cell.v != row) row = cell.v, v = block_of(row) - v0_;
    const int u = block_of(cell.u) - u0_;
    if (u == last_u && v == last_v) continue;
    last_u = u, last_v = v;
    for (int dv = -1; dv <= 1; ++dv) {
      const auto middle = is_beside_.begin() + static_cast<std::ptrdiff_t>(v + dv) * columns_ + u;
      std::fill(middle - 1, middle + 2, char{1});
    }
  }
}

bool Footprint::holds(const Eigen::Vector3d& point, double tolerance_m) const {
  if (std::abs(plane_->normal.dot(point) + plane_->d_m) > tolerance_m) return false;
  const Eigen::Vector3d place = point - plane_->origin;
  const int u = floor_to_int(place.dot(plane_->axis_u) * blocks_per_m_) - u0_;
  const int v = floor_to_int(place.dot(plane_->axis_v) * blocks_per_m_) - v0_;
  return u >= 0 && v >= 0 && u < columns_ && v < rows_ &&
         is_beside_[static_cast<std::size_t>(v) * columns_ + u] != 0;
}

}  // namespace ribbon_mapper
