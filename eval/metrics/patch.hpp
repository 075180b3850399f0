// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::eval {

/// A bounded plane in map, of the model or of the world: all that the metrics know of it.
struct Patch {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the seen side
  double d_m = 0.0;                                   ///< n.p + d = 0
  double area_m2 = 0.0;
  std::vector<Eigen::Vector3d> cells;  ///< centres of the seen cells (5 cm), on the plane
};

Patch patch_of(const Plane& plane);
std::vector<Patch> patches_of(const std::vector<Plane>& planes);

/// A plane with a grid of its own, laid over the cells of the patch; it has no outline.
Plane plane_of(const Patch& patch, std::int64_t id, double cell_size_m = 0.05);

/// Mean of the cells; the foot of the origin if there are none.
Eigen::Vector3d centroid_of(const Patch& patch);

}  // namespace ribbon_mapper::eval
