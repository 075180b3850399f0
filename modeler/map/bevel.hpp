// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/map/plane.hpp"
#include "modeler/map/plane_map_config.hpp"

namespace ribbon_mapper {

/// Along a concave edge, lines that straddle it pile up to a convincing plane across the corner
/// (a bevel), though every one of its points lies on one of the faces. So a plane most of whose
/// cells lie, as measured, on larger planes beside them is none.
std::vector<Plane> without_bevels(std::vector<Plane> planes, const PlaneMapConfig& config);

}  // namespace ribbon_mapper
