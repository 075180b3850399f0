// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns the axis-aligned bounding box of the outline, or of the cells if there is no outline
/// (map frame).
Eigen::AlignedBox3d bounding_box(const Plane& plane);

/// Converts planes to JSON, one plane per line:
/// {"planes": [{"id", "normal", "d", "area", "centroid", "bbox": [min, max], "outline"}]}.
/// Metres, map frame; n.p + d = 0 with n towards the observed side. The bytes are reproducible, and
/// numbers are written with all digits of a double.
std::string planes_to_json(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
