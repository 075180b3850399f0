// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Smallest axis-aligned box in map around the outline or, where there is none, around the cells.
Eigen::AlignedBox3d bounding_box(const Plane& plane);

/// Planes as JSON, one per line:
/// {"planes": [{"id", "normal", "d", "area", "centroid", "bbox": [min, max], "outline"}]},
/// n.p + d = 0 with n towards the seen side, metres, map frame. The same planes give the same
/// bytes, and every number is read back as exactly the same double.
std::string planes_to_json(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
