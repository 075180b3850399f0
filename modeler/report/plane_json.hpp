// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "modeler/report/report.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper {

/// A JSON value that keeps the order of its keys.

/// Returns a value rounded to 1 / `parts`.
inline double rounded(double value, double parts) { return std::round(value * parts) / parts; }

/// Returns metres in whole millimetres, or radians in milliradians. What is no number is 0.
inline std::int64_t in_millimetres(double value_m) {
  return std::isfinite(value_m) ? std::llround(1e3 * value_m) : 0;
}

/// Returns the text of a JSON value in ASCII, without '<', so that it ends no script element of
/// HTML (section 4.12.1.3 of the HTML standard). Bytes that are no UTF-8 are replaced.
std::string text_of(const Json& json);

/// Returns outlines as lists of rings, the outer one first: x, y, z, x, ... in map [mm].
Json outlines_in_map(const std::vector<Outline>& outlines);

/// Returns a plane as JSON text. Its rings are u, v, u, ... from the origin along the axes [mm].
std::string plane_json(const Plane& plane, const PlaneRemarks& remarks, bool with_cells);

}  // namespace ribbon_mapper
