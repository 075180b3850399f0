// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/outline.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/surface/cell_bitmap.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the boundaries of the closed cells as rings, in cells.
std::vector<Ring> boundary_rings(const Plane& plane, double stripe_gap_m) {
  CellBitmap bitmap(plane.cells,
                    static_cast<int>(std::ceil(0.5 * stripe_gap_m / plane.cell_size_m)));
  bitmap.close();
  bitmap.join_corners();
  std::vector<Ring> rings;
  for (const std::vector<GridCorner>& boundary : bitmap.boundaries()) {
    Ring& ring = rings.emplace_back();
    for (const GridCorner& corner : boundary) ring.emplace_back(corner.u, corner.v);
  }
  return rings;
}

/// Removes rings around less than `min_area`, but not the largest one.
void remove_specks(std::vector<Ring>& rings, double min_area) {
  const auto size = [](const Ring& ring) { return std::abs(signed_area(ring)); };
  const auto largest = std::max_element(
      rings.begin(), rings.end(), [&](const Ring& a, const Ring& b) { return size(a) < size(b); });
  std::iter_swap(rings.begin(), largest);
  rings.erase(std::remove_if(rings.begin() + 1, rings.end(),
                             [&](const Ring& ring) { return size(ring) < min_area; }),
              rings.end());
}

std::vector<Eigen::Vector3d> on_plane(const Plane& plane, const Ring& ring) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector2d& p : ring) {
    points.push_back(plane.origin + p.x() * plane.axis_u + p.y() * plane.axis_v);
  }
  return points;
}

Ring on_axes(const Plane& plane, const std::vector<Eigen::Vector3d>& points) {
  Ring ring;
  for (const Eigen::Vector3d& point : points) ring.push_back(on_axes(plane, point));
  return ring;
}

}  // namespace

Polygons seen_area(const Plane& plane, double stripe_gap_m, double tolerance_m) {
  if (plane.cells.empty()) return {};
  const double cell_m = plane.cell_size_m;
  std::vector<Ring> rings = boundary_rings(plane, stripe_gap_m);
  remove_specks(rings, stripe_gap_m * stripe_gap_m / (cell_m * cell_m));
  for (Ring& ring : rings) {
    for (Eigen::Vector2d& point : ring) point *= cell_m;
  }
  return simplified(polygons_of(rings), tolerance_m);
}

std::vector<Outline> outlines_of(const Plane& plane, const SurfaceConfig& config) {
  std::vector<Outline> outlines;
  for (const Polygon& polygon : seen_area(plane, config.stripe_gap_m, config.outline_tolerance_m)) {
    Outline& outline = outlines.emplace_back(Outline{on_plane(plane, polygon.outer), {}});
    for (const Ring& hole : polygon.holes) outline.holes.push_back(on_plane(plane, hole));
  }
  return outlines;
}

Polygon area_of(const Plane& plane, const Outline& outline) {
  Polygon polygon{on_axes(plane, outline.outer), {}};
  for (const auto& hole : outline.holes) polygon.holes.push_back(on_axes(plane, hole));
  return polygon;
}

Polygons areas_of(const Plane& plane, const std::vector<Outline>& outlines) {
  Polygons areas;
  for (const Outline& outline : outlines) areas.push_back(area_of(plane, outline));
  return areas;
}

std::vector<Plane> with_outlines(std::vector<Plane> planes, const SurfaceConfig& config) {
  for (Plane& plane : planes) {
    if (plane.outlines.empty()) plane.outlines = outlines_of(plane, config);
  }
  return planes;
}

}  // namespace ribbon_mapper
