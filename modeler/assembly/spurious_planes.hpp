// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Which planes are none, because most of their cells lie, as measured, on larger planes beside
/// them. Along a concave edge, lines that straddle it pile up to a convincing plane across the
/// corner (a bevel). And where few ribbons see a wall's end, the poor normals of some make a second
/// plane of almost its direction (a splinter), which a gap may part from the rest of the wall.
std::vector<bool> are_spurious(const std::vector<const Plane*>& planes, double bridged_gap_m,
                               const AssemblyConfig& config);

/// Those that are planes, the largest first.
std::vector<Plane> without_spurious_planes(std::vector<Plane> planes, double bridged_gap_m,
                                           const AssemblyConfig& config);

}  // namespace ribbon_mapper
