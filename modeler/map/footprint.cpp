// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/footprint.hpp"

#include <cmath>
#include <optional>

namespace ribbon_mapper {

Footprint::Footprint(const Plane& plane, double reach_m) : plane_(&plane), reach_m_(reach_m) {
  std::optional<std::uint64_t> last;
  for (const PlaneCell& cell : plane.cells) {
    const std::uint64_t block =
        block_at((cell.u + 0.5) * plane.cell_size_m, (cell.v + 0.5) * plane.cell_size_m, 0, 0);
    if (block != last) blocks_.insert(block);
    last = block;
  }
}

bool Footprint::holds(const Eigen::Vector3d& point, double tolerance_m) const {
  if (std::abs(plane_->normal.dot(point) + plane_->d_m) > tolerance_m) return false;
  const Eigen::Vector3d place = point - plane_->origin;
  const double u_m = place.dot(plane_->axis_u), v_m = place.dot(plane_->axis_v);
  for (int du = -1; du <= 1; ++du) {
    for (int dv = -1; dv <= 1; ++dv) {
      if (blocks_.count(block_at(u_m, v_m, du, dv))) return true;
    }
  }
  return false;
}

std::uint64_t Footprint::block_at(double u_m, double v_m, int du, int dv) const {
  return pair_key(static_cast<std::int32_t>(std::floor(u_m / reach_m_)) + du,
                  static_cast<std::int32_t>(std::floor(v_m / reach_m_)) + dv);
}

}  // namespace ribbon_mapper
