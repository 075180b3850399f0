// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/polygon/polygon_operations.hpp"

#include <algorithm>
#include <stdexcept>

#include "modeler/polygon/geos.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the polygons of what `operation` makes of a and b.
template <typename Operation>
Polygons overlay(const Polygons& a, const Polygons& b, const Operation& operation) {
  const Geos geos;
  Geos::Geometry first = geos.multipolygon_of(a), second = geos.multipolygon_of(b);
  GEOSGeometry* result = operation(geos.context(), first.get(), second.get());
  if (result == nullptr) {  // a ring touches itself, by rounding
    first = geos.made(GEOSMakeValid_r(geos.context(), first.get()));
    second = geos.made(GEOSMakeValid_r(geos.context(), second.get()));
    result = operation(geos.context(), first.get(), second.get());
  }
  return geos.polygons_in(geos.made(result).get());
}

Eigen::Vector2d extent_of(const Ring& ring) {
  Eigen::Vector2d low = ring.front(), high = ring.front();
  for (const Eigen::Vector2d& point : ring) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return high - low;
}

}  // namespace

Polygons polygons_of(const std::vector<Ring>& rings) {
  const Geos geos;
  const Geos::Geometry lines = geos.lines_of(rings);
  return geos.polygons_in(geos.made(GEOSBuildArea_r(geos.context(), lines.get())).get());
}

Polygons simplified(const Polygons& polygons, double tolerance) {
  const Geos geos;
  const Geos::Geometry all = geos.multipolygon_of(polygons);
  return geos.polygons_in(
      geos.made(GEOSTopologyPreserveSimplify_r(geos.context(), all.get(), tolerance)).get());
}

bool is_valid(const Polygons& polygons) {
  const auto is_ring = [](const Ring& ring) { return ring.size() >= 3; };
  for (const Polygon& polygon : polygons) {
    if (!is_ring(polygon.outer)) return false;
    if (!std::all_of(polygon.holes.begin(), polygon.holes.end(), is_ring)) return false;
  }
  const Geos geos;
  return GEOSisValid_r(geos.context(), geos.multipolygon_of(polygons).get()) == 1;
}

Polygons intersection(const Polygons& a, const Polygons& b) {
  return overlay(a, b, &GEOSIntersection_r);
}

Polygons united(const Polygons& a, const Polygons& b) { return overlay(a, b, &GEOSUnion_r); }

Polygons difference(const Polygons& a, const Polygons& b) {
  return overlay(a, b, &GEOSDifference_r);
}

Eigen::Vector2d inmost_point(const Polygons& polygons, double tolerance) {
  const Geos geos;
  const Geos::Geometry all = geos.multipolygon_of(polygons);
  const Geos::Geometry radius =
      geos.made(GEOSMaximumInscribedCircle_r(geos.context(), all.get(), tolerance));
  const Geos::Geometry centre = geos.made(GEOSGeomGetStartPoint_r(geos.context(), radius.get()));
  Eigen::Vector2d point;
  GEOSGeomGetX_r(geos.context(), centre.get(), &point.x());
  GEOSGeomGetY_r(geos.context(), centre.get(), &point.y());
  return point;
}

Polygons grown(const Polygons& polygons, double distance) {
  constexpr int kSegmentsOfACurve = 1;
  constexpr double kLongestMitre = 2.0;
  const Geos geos;
  const Geos::Geometry all = geos.multipolygon_of(polygons);
  return geos.polygons_in(
      geos.made(GEOSBufferWithStyle_r(geos.context(), all.get(), distance, kSegmentsOfACurve,
                                      GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, kLongestMitre))
          .get());
}

Eigen::Vector2d middle_of_largest_circle(const Polygons& polygons) {
  if (polygons.empty()) throw std::invalid_argument("No polygons have no largest circle.");
  const auto largest =
      std::max_element(polygons.begin(), polygons.end(),
                       [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  return inmost_point({*largest}, 0.01 * extent_of(largest->outer).maxCoeff());
}

}  // namespace ribbon_mapper
