// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/polygon/polygon.hpp"
#include "modeler/surface/plane.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper {

/// Returns the seen area of a plane as polygons, in metres along axis_u and axis_v from the origin.
///
/// Stripes between scan lines are closed, see SurfaceConfig::stripe_gap_m: wider gaps, such as
/// doors, stay open. So are parts and holes left out that are smaller than a square of that side,
/// which the lines do not resolve; the largest part always remains. Boundaries are within
/// `tolerance_m` of those of the cells.
Polygons seen_area(const Plane& plane, double stripe_gap_m, double tolerance_m);

/// Returns the outlines of the seen area of a plane, as seen_area(), in map.
std::vector<Outline> outlines_of(const Plane& plane, const SurfaceConfig& config);

/// Returns the planes with the outlines that planes as built do not have, see outlines_of().
std::vector<Plane> with_outlines(std::vector<Plane> planes, const SurfaceConfig& config);

/// Returns the position of a point along axis_u and axis_v from the origin of a plane [m].
inline Eigen::Vector2d on_axes(const Plane& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d offset = point - plane.origin;
  return {offset.dot(plane.axis_u), offset.dot(plane.axis_v)};
}

/// Returns an outline, projected on a plane, in metres along its axes from its origin.
Polygon area_of(const Plane& plane, const Outline& outline);

/// Returns outlines, projected on a plane, as area_of().
Polygons areas_of(const Plane& plane, const std::vector<Outline>& outlines);

/// Returns the outlines of a plane in metres along its axes from its origin.
inline Polygons areas_of(const Plane& plane) { return areas_of(plane, plane.outlines); }

}  // namespace ribbon_mapper
