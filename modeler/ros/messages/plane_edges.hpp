// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// A straight line from one point to another, in map [m].
using Edge = std::array<Eigen::Vector3d, 2>;

/// Returns the edges where planes meet: the sides of outlines that lie on another plane, where that
/// was seen as well. Both planes of an edge give their sides; see join_at_corner_lines().
std::vector<Edge> edges_of(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
