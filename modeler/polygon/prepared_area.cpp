// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/polygon/prepared_area.hpp"

#include "modeler/polygon/geos.hpp"

namespace ribbon_mapper {

struct PreparedArea::Prepared {
  explicit Prepared(const Polygons& polygons)
      : area(geos.multipolygon_of(polygons)), index(GEOSPrepare_r(geos.context(), area.get())) {}
  ~Prepared() { GEOSPreparedGeom_destroy_r(geos.context(), index); }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  const Geos geos;
  const Geos::Geometry area;
  const GEOSPreparedGeometry* const index;
};

PreparedArea::PreparedArea(const Polygons& polygons)
    : prepared_(std::make_unique<Prepared>(polygons)) {}
PreparedArea::~PreparedArea() = default;

bool PreparedArea::holds(const Eigen::Vector2d& point) const {
  const Geos& geos = prepared_->geos;
  const Geos::Geometry there =
      geos.made(GEOSGeom_createPointFromXY_r(geos.context(), point.x(), point.y()));
  return GEOSPreparedIntersects_r(geos.context(), prepared_->index, there.get()) == 1;
}

}  // namespace ribbon_mapper
