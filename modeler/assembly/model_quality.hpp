// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// When one plane of a model is another one a second time.
struct DuplicateRule {
  double max_angle_deg = 5.0;  ///< between the normals: both sides of a wall are 180 apart
  double max_offset_m = 0.10;  ///< of the smaller plane's centroid from the larger plane
  /// They touch: a cell of the smaller one lies within max_offset_m of the larger plane, and no
  /// further than this from its cells [m]. As wide as the stripes between scan lines may be.
  double touching_m = 0.3;
};

/// Indices of the planes that are duplicates of a larger one.
std::vector<std::size_t> duplicates_of_larger(const std::vector<Plane>& planes,
                                              const DuplicateRule& rule);

/// Median distance of the points that the planes have taken from their planes [m], from the cells:
/// count, mean and variance of the distances in each, taken as normally distributed. Nothing
/// without points.
std::optional<double> median_residual_m(const std::vector<Plane>& planes);

/// Number of the points.
std::size_t point_count(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
