// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modeler/polygon/polygon.hpp"

namespace ribbon_mapper {

// By GEOS (https://libgeos.org). All of these return polygons that are valid by the OGC's Simple
// Features. They throw std::invalid_argument if a ring has less than three points or one that is
// not finite, and std::runtime_error with its reason if GEOS refuses. Intersection, union and
// difference mend polygons that rounding has made invalid.

/// Returns the areas that are inside an odd number of rings. Rings must not touch each other.
Polygons polygons_of(const std::vector<Ring>& rings);

/// Returns polygons with fewer corners, whose boundaries are within `tolerance` of the former ones.
/// Holes and parts remain, and none overlap.
Polygons simplified(const Polygons& polygons, double tolerance);

/// Returns true if no ring intersects itself or another one, and the polygons do not overlap.
bool is_valid(const Polygons& polygons);

/// Returns the area that is in both.
Polygons intersection(const Polygons& a, const Polygons& b);

/// Returns the area that is in one of them, or in both.
Polygons united(const Polygons& a, const Polygons& b);

/// Returns the area of `a` that is not in `b`.
Polygons difference(const Polygons& a, const Polygons& b);

/// Returns the centre of a largest circle in the polygons, within `tolerance`. There must be one
/// polygon at least.
Eigen::Vector2d inmost_point(const Polygons& polygons, double tolerance);

/// Returns the area within `distance` of the polygons; for a negative distance, the area that is
/// at least as far from everything outside. Corners stay corners.
Polygons grown(const Polygons& polygons, double distance);

/// Returns the middle of the largest circle in polygons, within a hundredth of their extent: a
/// place for a label. Throws std::invalid_argument if there are none.
Eigen::Vector2d middle_of_largest_circle(const Polygons& polygons);

}  // namespace ribbon_mapper
