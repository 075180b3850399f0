// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Moves corners of outlines onto the lines where planes meet, so that neighbours share these
/// lines.
///
/// A corner moves if it is within `reach_m` of where its plane intersects another one, and that
/// plane was seen within `reach_m` of there. It moves within its plane: to the intersection of
/// three planes, or to the nearest line. Planes that are within 30 degrees of each other have no
/// line. An outline that would overlap itself stays as it is.
void join_at_corner_lines(std::vector<Plane>& planes, double reach_m);

}  // namespace ribbon_mapper
