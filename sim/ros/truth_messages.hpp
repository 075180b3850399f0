// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/PlaneArray.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "sim/truth/truth.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {

/// Returns the planes of the world as far as the beams saw them, with their cells.
PlaneArray truth_message(const std::vector<TruthPlane>& planes, const std_msgs::Header& header);

/// Returns horizontal sections of the world at some heights, as lines for rviz.
visualization_msgs::MarkerArray world_markers(const World& world, const std_msgs::Header& header);

}  // namespace ribbon_mapper::sim
