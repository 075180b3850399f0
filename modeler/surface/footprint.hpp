// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "modeler/geometry/grid_keys.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Where on a plane there are cells, in blocks as wide as a reach: which points lie on the plane
/// and beside what was seen of it. The plane must outlive it.
class Footprint {
 public:
  Footprint(const Plane& plane, double reach_m);

  /// Within `tolerance_m` of the plane and, in it, within the reach of a cell; true for no point
  /// that is further than twice the reach from all of them along an axis.
  bool holds(const Eigen::Vector3d& point, double tolerance_m) const {
    if (std::abs(plane_->normal.dot(point) + plane_->d_m) > tolerance_m) return false;
    const Eigen::Vector3d place = point - plane_->origin;
    return covers(place.dot(plane_->axis_u) / plane_->cell_size_m,
                  place.dot(plane_->axis_v) / plane_->cell_size_m);
  }

  /// The same of a point of the plane, by its place in the grid [cells].
  bool covers(double place_u, double place_v) const {
    const int u = floor_to_int(place_u * blocks_per_cell_) - u0_;
    const int v = floor_to_int(place_v * blocks_per_cell_) - v0_;
    return u >= 0 && v >= 0 && u < columns_ && v < rows_ && is_beside_[index(u, v)] != 0;
  }

  /// Calls function(centre) for each block whose points it covers.
  template <typename Function>
  void for_each_block(const Function& function) const {
    const double side_m = plane_->cell_size_m / blocks_per_cell_;
    for (int v = 0; v < rows_; ++v) {
      for (int u = 0; u < columns_; ++u) {
        if (is_beside_[index(u, v)] == 0) continue;
        function(Eigen::Vector3d(plane_->origin + (u + u0_ + 0.5) * side_m * plane_->axis_u +
                                 (v + v0_ + 0.5) * side_m * plane_->axis_v));
      }
    }
  }

  const Plane& plane() const { return *plane_; }

 private:
  std::size_t index(int u, int v) const { return static_cast<std::size_t>(v) * columns_ + u; }
  void mark_cells();
  void mark_around();

  const Plane* plane_;
  double blocks_per_cell_;
  int u0_ = 0, v0_ = 0, columns_ = 0, rows_ = 0;
  std::vector<char> is_beside_;  // of each block: it or one around it holds a cell
};

}  // namespace ribbon_mapper
