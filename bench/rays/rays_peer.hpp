// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim/rays/ray_caster.hpp"
#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::bench {

using sim::Ray;  ///< the ray of the simulator

/// Sets the ranges of the first hits [m], infinite for rays without one within `max_range_m`.
using RayCasting = std::function<void(const std::vector<Ray>& rays, double max_range_m,
                                      std::vector<float>& ranges)>;

/// Returns btCollisionWorld::rayTest in a world with one collision object for each shape.
RayCasting bullet_ray_test(const std::vector<sim::Shape>& shapes);

}  // namespace ribbon_mapper::bench
