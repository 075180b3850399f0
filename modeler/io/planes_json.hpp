// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "modeler/io/model_label.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns the axis-aligned bounding box of the outlines, or of the cells if there are none
/// (map frame).
Eigen::AlignedBox3d bounding_box(const Plane& plane);

/// Converts planes to JSON, one plane per line:
/// {"frame", "unit", "run", "origin", "planes": [{"id", "normal", "d", "area", "centroid",
/// "bbox": [min, max], "outlines"}]}.
///
/// "outlines" is built as the coordinates of a GeoJSON MultiPolygon (RFC 7946): for each outline a
/// list of rings, the outer one first, then holes. Here, the first point is not repeated.
/// Metres; n.p + d = 0 with n towards the observed side. Numbers have all digits of a double, so
/// that ModelLabel::origin is not subtracted: it is stated for the other files of the model. The
/// bytes are reproducible.
///
/// With `labels`, one for each plane, planes have "label", "label_confidence" and, where a person
/// has left one, "note".
std::string planes_to_json(const std::vector<Plane>& planes, const ModelLabel& label = {},
                           const std::vector<PlaneLabel>& labels = {});

/// Converts rooms to JSON: {"frame", "unit", "run", "rooms": [{"name", "area", "centre",
/// "outlines"}], "passages": [{"rooms": [a, b], "plane", "jambs": [p, q], "sill", "head",
/// "confidence"}]}.
///
/// "outlines" are the coordinates of a GeoJSON MultiPolygon in map, without the repeated first
/// point. Names are those of room_name(). Passages count rooms from 0; "head" is null if no lintel
/// was seen.
std::string rooms_to_json(const Rooms& rooms, const ModelLabel& label = {});

}  // namespace ribbon_mapper
