// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos_c.h>

#include <memory>
#include <string>
#include <vector>

#include "modeler/polygon/polygon.hpp"

namespace ribbon_mapper {

/// A context of GEOS, with the way from our types to its own and back.
///
/// All members throw std::invalid_argument if a ring has less than three points or one that is not
/// finite, and std::runtime_error with GEOS's reason if it refuses.
class Geos {
 public:
  /// Destroys a geometry in its context.
  struct Destroy {
    GEOSContextHandle_t context;  ///< in which the geometry was made
    /// Destroys a geometry.
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
  };
  /// A geometry of GEOS. It must not outlive its context.
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

  /// Creates a context.
  Geos();
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  /// Returns the handle of the context.
  GEOSContextHandle_t context() const { return context_.get(); }
  /// Takes what GEOS has made.
  Geometry made(GEOSGeometry* geometry) const;

  /// Converts polygons.
  Geometry multipolygon_of(const Polygons& polygons) const;
  /// Converts rings to closed lines.
  Geometry lines_of(const std::vector<Ring>& rings) const;
  /// Converts a geometry to its polygons. Leaves out lines and points.
  Polygons polygons_in(const GEOSGeometry* geometry) const;

 private:
  GEOSCoordSequence* coordinates_of(const Ring& ring) const;
  Geometry linear_ring_of(const Ring& ring) const;
  Geometry geometry_of(const Polygon& polygon) const;
  Geometry collection_of(int type, std::vector<Geometry> parts) const;
  Polygon polygon_of(const GEOSGeometry* geometry) const;
  Ring ring_of(const GEOSGeometry* geometry) const;

  std::unique_ptr<std::string> reason_;  // GEOS keeps its address
  std::unique_ptr<GEOSContextHandle_HS, void (*)(GEOSContextHandle_t)> context_;
};

}  // namespace ribbon_mapper
