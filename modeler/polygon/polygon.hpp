// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace ribbon_mapper {

/// A closed line of at least three points. The first point is not repeated.
using Ring = std::vector<Eigen::Vector2d>;

/// An area with holes.
struct Polygon {
  Ring outer;               ///< outer boundary, counter-clockwise
  std::vector<Ring> holes;  ///< boundaries of the holes, clockwise
};

/// Areas that do not overlap.
using Polygons = std::vector<Polygon>;

/// Returns the distance of a point from polygons: 0 inside, infinite if there are none.
double distance(const Polygons& polygons, const Eigen::Vector2d& point);

/// Returns the area inside a ring: positive if the ring is counter-clockwise, negative otherwise.
double signed_area(const Ring& ring);

/// Returns the area of a polygon without its holes.
double area(const Polygon& polygon);

/// Returns the area of all polygons.
double area(const Polygons& polygons);

}  // namespace ribbon_mapper
