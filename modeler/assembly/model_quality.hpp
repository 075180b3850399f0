// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Limits within which a plane is a duplicate of a larger one.
struct DuplicateRule {
  double max_angle_deg = 5.0;  ///< largest angle between normals; sides of a wall are 180 apart
  double max_offset_m = 0.10;  ///< largest distance of the smaller one's centroid from the plane
  /// Largest distance, within the larger plane, of a cell of the smaller one from its cells [m]. As
  /// wide as the stripes between scan lines may be.
  double touching_m = 0.3;
};

/// Returns the ascending indices of the planes that are duplicates of a larger one.
std::vector<std::size_t> duplicates_of_larger(const std::vector<Plane>& planes,
                                              const DuplicateRule& rule);

/// Returns the median distance of points from their planes [m], or nothing without points.
/// Estimates it from the cells: the distances within each are taken as normally distributed.
std::optional<double> median_residual_m(const std::vector<Plane>& planes);

/// Returns the number of points in the cells of all planes.
std::size_t point_count(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
