// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/association/association_config.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Flags spurious planes: most of their cells lie, as measured, on larger planes next to them.
///
/// There are two kinds. Along a concave edge, lines that straddle it accumulate to a plane across
/// the corner. And where few ribbons see the end of a wall, some poor normals make a second plane
/// of almost the same direction, possibly beyond a gap. If it is tilted by more than the gate of
/// the angle, its cells lie on the wall within half the gate of the distance, as they would on a
/// plane of their own: a door that stands ajar is not spurious.
std::vector<bool> are_spurious(const std::vector<const Plane*>& planes,
                               const AssociationGates& gates, double bridged_gap_m,
                               const AssemblyConfig& config);

/// Returns the planes that are not spurious, the largest first.
std::vector<Plane> without_spurious_planes(std::vector<Plane> planes, const AssociationGates& gates,
                                           double bridged_gap_m, const AssemblyConfig& config);

}  // namespace ribbon_mapper
