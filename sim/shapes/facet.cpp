// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/shapes/facet.hpp"

#include <Eigen/Geometry>

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

constexpr double kSameCorner_m = 1e-9;

/// By a corner and the two edges from it, whose cross product is `normal`.
Facet facet_of(const Vector3d& corner, const Vector3d& edge_u, const Vector3d& edge_v,
               const Vector3d& normal, double max_uv) {
  const auto form = [&](const Vector3d& n) {
    return Facet::Form{{n.x(), n.y(), n.z()}, -n.dot(corner)};
  };
  const double square = normal.squaredNorm();
  return {form(normal / std::sqrt(square)), form(edge_v.cross(normal) / square),
          form(normal.cross(edge_u) / square), max_uv};
}

/// Whether `first` (a, b, c) and `second` (a, c, d) are the halves of a parallelogram.
bool are_halves(const Triangle& first, const Triangle& second) {
  const auto& [a, b, c] = first.corners_m;
  const auto& [a2, c2, d] = second.corners_m;
  return first.face == second.face && a == a2 && c == c2 &&
         (a + c - b - d).lpNorm<Eigen::Infinity>() < kSameCorner_m;
}

}  // namespace

std::vector<FacetOfTriangles> facets_of(const std::vector<Triangle>& triangles) {
  std::vector<FacetOfTriangles> facets;
  for (std::size_t i = 0; i < triangles.size();) {
    const bool halves = i + 1 < triangles.size() && are_halves(triangles[i], triangles[i + 1]);
    const std::size_t count = halves ? 2 : 1;
    const auto& [a, b, c] = triangles[i].corners_m;
    const Vector3d edge_u = b - a, edge_v = halves ? Vector3d(c - b) : Vector3d(c - a);
    const Vector3d normal = edge_u.cross(edge_v);
    if (normal.squaredNorm() > 0.0)
      facets.push_back({facet_of(a, edge_u, edge_v, normal, halves ? 2.0 : 1.0), i, count});
    i += count;
  }
  return facets;
}

}  // namespace ribbon_mapper::sim
