// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::eval {

/// A bounded plane of the model or of the world in the map frame, as the metrics need it.
struct Patch {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit length, towards the observed side
  double d_m = 0.0;                                   ///< n.p + d = 0
  double area_m2 = 0.0;                               ///< observed area
  /// Direction of the rows of cells, on the plane; any if there is none.
  std::optional<Eigen::Vector3d> axis_u = std::nullopt;
  std::vector<Eigen::Vector3d> cells;  ///< centres of the observed cells (5 cm), on the plane
};

/// Converts a plane of the model.
Patch patch_of(const Plane& plane);

/// Converts planes of the model.
std::vector<Patch> patches_of(const std::vector<Plane>& planes);

/// Converts a patch to a plane with a grid over its cells and without an outline.
Plane plane_of(const Patch& patch, std::int64_t id, double cell_size_m = 0.05);

/// Returns the mean of the cells, or the point nearest to the origin if there are none.
Eigen::Vector3d centroid_of(const Patch& patch);

}  // namespace ribbon_mapper::eval
