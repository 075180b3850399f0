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

/// A hypothesis with the cells that its ribbons have seen, in the frame of the observations.
class Surface {
 public:
  Surface(const Hypothesis& hypothesis, const PosedObservations& observations, double cell_size_m);

  const Plane& plane() const { return plane_; }
  Plane take_plane() { return std::move(plane_); }

  /// Column and row in the grid, with fractions, and distance from the plane [m].
  Eigen::Vector3d place_of(const Eigen::Vector3d& point) const { return grid_.place_of(point); }
  /// A point of no ribbon, by its place; refresh() makes its cell part of the plane.
  void add(const Eigen::Vector3d& place, std::uint32_t count) { grid_.add_at(place, count); }
  /// A ribbon of no hypothesis, most of whose points were added.
  void own(std::uint32_t ribbon) { plane_.ribbons.push_back(ribbon); }
  void refresh();

 private:
  Plane plane_;
  CellGrid grid_;
};

}  // namespace ribbon_mapper
