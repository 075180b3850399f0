// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace ribbon_mapper::eval {

using Segment = std::array<Eigen::Vector2d, 2>;
using Chain = std::vector<Eigen::Vector2d>;

/// Strings segments together where their ends meet (to `tolerance_m`), and leaves out points that
/// change a chain by less than that: a tessellated cylinder becomes one polygon of few corners. A
/// closed chain ends where it begins.
std::vector<Chain> chains_of(const std::vector<Segment>& segments, double tolerance_m);

/// Douglas and Peucker: the chain with those points only that lie further than `tolerance_m` from
/// the line between kept ones.
Chain simplified(const Chain& chain, double tolerance_m);

}  // namespace ribbon_mapper::eval
