// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/world/world.hpp"

namespace ribbon_mapper::eval {

/// Returns horizontal sections of the world at the heights of a seat, a table and a head [m], for
/// the figure.
std::vector<std::vector<Eigen::Vector2d>> world_outlines(const sim::World& world);

}  // namespace ribbon_mapper::eval
