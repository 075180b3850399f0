// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/polygon/geos.hpp"

#include <algorithm>
#include <stdexcept>

namespace ribbon_mapper {
namespace {

/// Returns the geometries, which their owners no longer destroy.
std::vector<GEOSGeometry*> released(std::vector<Geos::Geometry>& owners) {
  std::vector<GEOSGeometry*> geometries;
  geometries.reserve(owners.size());
  for (Geos::Geometry& owner : owners) geometries.push_back(owner.release());
  return geometries;
}

/// Makes a ring turn to the left if `left`, otherwise to the right.
Ring turning(Ring ring, bool left) {
  if ((signed_area(ring) > 0.0) != left) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace

Geos::Geos() : reason_(std::make_unique<std::string>()), context_(GEOS_init_r(), &GEOS_finish_r) {
  GEOSContext_setErrorMessageHandler_r(
      context(),
      [](const char* message, void* reason) { *static_cast<std::string*>(reason) = message; },
      reason_.get());
}

Geos::Geometry Geos::made(GEOSGeometry* geometry) const {
  if (geometry == nullptr) throw std::runtime_error("GEOS refuses polygons: " + *reason_);
  return {geometry, Destroy{context()}};
}

GEOSCoordSequence* Geos::coordinates_of(const Ring& ring) const {
  const auto is_finite = [](const Eigen::Vector2d& point) { return point.allFinite(); };
  if (ring.size() < 3 || !std::all_of(ring.begin(), ring.end(), is_finite)) {
    throw std::invalid_argument("A ring needs at least three points, and finite coordinates.");
  }
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(context(), size + 1, 2);
  if (points == nullptr) throw std::runtime_error("GEOS refuses polygons: " + *reason_);
  for (unsigned i = 0; i <= size; ++i) {
    const Eigen::Vector2d& point = ring[i % size];
    GEOSCoordSeq_setXY_r(context(), points, i, point.x(), point.y());
  }
  return points;
}

Geos::Geometry Geos::linear_ring_of(const Ring& ring) const {
  return made(GEOSGeom_createLinearRing_r(context(), coordinates_of(ring)));
}

Geos::Geometry Geos::geometry_of(const Polygon& polygon) const {
  std::vector<Geometry> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(linear_ring_of(hole));
  Geometry outer = linear_ring_of(polygon.outer);
  std::vector<GEOSGeometry*> inner = released(holes);
  return made(GEOSGeom_createPolygon_r(context(), outer.release(), inner.data(),
                                       static_cast<unsigned>(inner.size())));
}

Geos::Geometry Geos::collection_of(int type, std::vector<Geometry> parts) const {
  std::vector<GEOSGeometry*> all = released(parts);
  return made(
      GEOSGeom_createCollection_r(context(), type, all.data(), static_cast<unsigned>(all.size())));
}

Geos::Geometry Geos::multipolygon_of(const Polygons& polygons) const {
  std::vector<Geometry> parts;
  for (const Polygon& polygon : polygons) parts.push_back(geometry_of(polygon));
  return collection_of(GEOS_MULTIPOLYGON, std::move(parts));
}

Geos::Geometry Geos::lines_of(const std::vector<Ring>& rings) const {
  std::vector<Geometry> lines;
  for (const Ring& ring : rings) {
    lines.push_back(made(GEOSGeom_createLineString_r(context(), coordinates_of(ring))));
  }
  return collection_of(GEOS_MULTILINESTRING, std::move(lines));
}

Polygons Geos::polygons_in(const GEOSGeometry* geometry) const {
  Polygons polygons;
  for (int i = 0; i < GEOSGetNumGeometries_r(context(), geometry); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(context(), geometry, i);
    if (GEOSGeomTypeId_r(context(), part) != GEOS_POLYGON) continue;
    if (GEOSisEmpty_r(context(), part) == 0) polygons.push_back(polygon_of(part));
  }
  return polygons;
}

Polygon Geos::polygon_of(const GEOSGeometry* geometry) const {
  Polygon polygon{turning(ring_of(GEOSGetExteriorRing_r(context(), geometry)), true), {}};
  for (int i = 0; i < GEOSGetNumInteriorRings_r(context(), geometry); ++i) {
    const GEOSGeometry* hole = GEOSGetInteriorRingN_r(context(), geometry, i);
    polygon.holes.push_back(turning(ring_of(hole), false));
  }
  return polygon;
}

Ring Geos::ring_of(const GEOSGeometry* geometry) const {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(context(), geometry);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(context(), points, &size);
  Ring ring(size - 1);  // the last point is the first
  for (unsigned i = 0; i < ring.size(); ++i) {
    GEOSCoordSeq_getXY_r(context(), points, i, &ring[i].x(), &ring[i].y());
  }
  return ring;
}

}  // namespace ribbon_mapper
