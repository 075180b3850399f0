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
  /// A ribbon of no hypothesis, most of whose points were added.
  void own(std::uint32_t ribbon) { plane_.ribbons.push_back(ribbon); }
  void refresh();

 private:
  Plane plane_;
  CellGrid grid_;
};

/// Gives each point of no ribbon, or of a ribbon of no surface (one whose normal was spoilt by an
/// edge or a short base line), to the surface that it lies on, beside what ribbons have seen of
/// that: the area of a small plane, or of one seen at a slant, is that of all that was seen.
void take_strays(const Evidence& evidence, const PlaneMapConfig& config,
                 std::vector<Surface>& surfaces);

}  // namespace ribbon_mapper
