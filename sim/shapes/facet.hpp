// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {

/// A triangle or a parallelogram as a ray's intersection needs it: its plane n.p + d = 0, and two
/// more planes that give the coordinates u and v of a point p along its two edges as n.p + d, 0 to
/// 1 within (Baldwin and Weber, "Fast ray-triangle intersections by coordinate transformation",
/// 2016).
struct Facet {
  struct Form {
    std::array<double, 3> n;
    double d;
  };
  Form plane, u, v;
  double max_uv;  ///< u + v is at most 1 in a triangle, 2 in a parallelogram
};

/// A facet with the triangles it was made of.
struct FacetOfTriangles {
  Facet facet;
  std::size_t first, count;  ///< indices into the triangles given
};

/// The facets of `triangles`: two successive halves of a parallelogram of one face become one
/// facet; triangles without area are left out.
std::vector<FacetOfTriangles> facets_of(const std::vector<Triangle>& triangles);

}  // namespace ribbon_mapper::sim
