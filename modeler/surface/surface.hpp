// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>

#include "modeler/association/hypothesis.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/cell_grid.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// The plane of a hypothesis with the cells that its ribbons have seen, in the model's frame.
class Surface {
 public:
  /// Creates the surface of a hypothesis of these observations.
  Surface(const Hypothesis& hypothesis, const PosedObservations& observations, double cell_size_m);

  /// Returns the plane with its seen cells, as of the last refresh().
  const Plane& plane() const { return plane_; }
  /// Moves the plane out of the surface.
  Plane take_plane() { return std::move(plane_); }

  /// Returns the position of a point in the grid: fractional column and row [cells], and distance
  /// from the plane [m].
  Eigen::Vector3d grid_position(const Eigen::Vector3d& point) const {
    return grid_.grid_position(point);
  }
  /// Adds `count` points at the same grid_position(). They become part of plane() by refresh().
  void add(const Eigen::Vector3d& position, std::uint32_t count) { grid_.add_at(position, count); }
  /// Adds the index of a ribbon to those of the plane, without its points.
  void add_ribbon(std::uint32_t ribbon) { plane_.ribbons.push_back(ribbon); }
  /// Updates the cells, ribbons, area and centroid of plane().
  void refresh();

 private:
  Plane plane_;
  CellGrid grid_;
};

}  // namespace ribbon_mapper
