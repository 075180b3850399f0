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

/// Decides which points lie on a plane near its seen cells, by blocks as wide as a given reach.
class Footprint {
 public:
  /// Creates the footprint of a plane, which must outlive it, with a reach in the plane [m].
  Footprint(const Plane& plane, double reach_m);

  /// Returns true if a point lies within `tolerance_m` of the plane and near its cells.
  ///
  /// Accepts all points within the reach of a cell, and none that is further than twice the reach
  /// from every cell along an axis of the grid.
  bool holds(const Eigen::Vector3d& point, double tolerance_m) const {
    if (std::abs(plane_->normal.dot(point) + plane_->d_m) > tolerance_m) return false;
    const Eigen::Vector3d offset = point - plane_->origin;
    return covers(offset.dot(plane_->axis_u) / plane_->cell_size_m,
                  offset.dot(plane_->axis_v) / plane_->cell_size_m);
  }

  /// Returns true if a point of the plane lies near its cells, as in holds(). The point is given by
  /// its position in the grid [cells].
  bool covers(double grid_u, double grid_v) const {
    const int u = floor_to_int(grid_u * blocks_per_cell_) - u0_;
    const int v = floor_to_int(grid_v * blocks_per_cell_) - v0_;
    return u >= 0 && v >= 0 && u < columns_ && v < rows_ && is_beside_[index(u, v)] != 0;
  }

  /// Calls function(centre) for each block whose points are accepted, with its centre [m].
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

  /// Returns the plane.
  const Plane& plane() const { return *plane_; }

 private:
  std::size_t index(int u, int v) const { return static_cast<std::size_t>(v) * columns_ + u; }
  void mark_cells();
  void mark_around();

  const Plane* plane_;
  double blocks_per_cell_;
  int u0_ = 0, v0_ = 0, columns_ = 0, rows_ = 0;
  std::vector<char> is_beside_;  // by block: it or a neighbour holds a cell
};

}  // namespace ribbon_mapper
