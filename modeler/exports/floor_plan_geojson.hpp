// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/floor_plan/floor_plan.hpp"
#include "modeler/io/model_label.hpp"

namespace ribbon_mapper {

/// Converts a floor plan to GeoJSON (RFC 7946), one feature per line; docs/exports.md lists the
/// properties.
///
/// Coordinates are metres in the label's frame, not longitude and latitude. The member
/// "coordinate_system" says so to people; "crs", which RFC 7946 knows by agreement only, says so to
/// GDAL and QGIS. They are rounded to 0.1 mm. ModelLabel::origin is
/// not subtracted. The bytes are reproducible.
std::string floor_plan_to_geojson(const FloorPlan& plan, const ModelLabel& label = {});

}  // namespace ribbon_mapper
