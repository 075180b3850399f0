// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "modeler/map/cell_grid.hpp"
#include "modeler/map/evidence.hpp"
#include "modeler/map/hypothesis.hpp"
#include "modeler/map/plane.hpp"
#include "modeler/map/plane_map_config.hpp"

namespace ribbon_mapper {

/// A hypothesis with the cells that its ribbons have seen, in the frame of the evidence.
class Surface {
 public:
  Surface(const Hypothesis& hypothesis, const Evidence& evidence, const PlaneMapConfig& config);

  const Plane& plane() const { return plane_; }

  /// Cells that points of no ribbon have seen; refresh() makes them part of the plane.
  void add(const Eigen::Vector3d& point, std::uint32_t count) { grid_.add(point, count); }
  /// The same of a ribbon that has joined no hypothesis.
  void take(std::uint32_t index, const Ribbon& ribbon, const Pose& T_world_base);
  void refresh();

 private:
  Plane plane_;
  CellGrid grid_;
};

/// Gives each point of no ribbon to the surface that it lies on, beside what ribbons have seen of
/// that: the area of a small plane, or of one seen at a slant, is that of all that was seen.
void take_strays(const Evidence& evidence, const PlaneMapConfig& config,
                 std::vector<Surface>& surfaces);

}  // namespace ribbon_mapper
