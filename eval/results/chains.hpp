// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace ribbon_mapper::eval {

/// A line segment by its two ends.
using Segment = std::array<Eigen::Vector2d, 2>;

/// A polyline by its corners; a closed one ends where it begins.
using Chain = std::vector<Eigen::Vector2d>;

/// Joins segments whose ends coincide to within `tolerance_m` into simplified chains. A tessellated
/// cylinder becomes one polygon of few corners.
std::vector<Chain> chains_of(const std::vector<Segment>& segments, double tolerance_m);

/// Simplifies a chain by the Douglas-Peucker algorithm: removed points lie within `tolerance_m` of
/// the line between their kept neighbours.
Chain simplified(const Chain& chain, double tolerance_m);

}  // namespace ribbon_mapper::eval
