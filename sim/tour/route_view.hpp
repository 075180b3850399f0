// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sim/robot/hokuyo.hpp"
#include "sim/robot/tilt_profile.hpp"
#include "sim/tour/route.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {

/// Returns in one line what a sample of the laser's rays sees along a route, for the user. Throws
/// std::runtime_error if that is nothing, or only unbounded planes in a world that has more: the
/// route lies outside.
std::string route_view(const World& world, const Route& route, const TiltProfile& tilt,
                       const HokuyoConfig& hokuyo);

}  // namespace ribbon_mapper::sim
