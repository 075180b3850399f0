// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim/rays/ray_caster.hpp"
#include "sim/shapes/shape.hpp"
#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::bench {

using sim::Ray;

/// Ranges of first hits [m], infinite where there is none within `max_range_m`.
using RayCasting = std::function<void(const std::vector<Ray>& rays, double max_range_m,
                                      std::vector<float>& ranges)>;

/// btCollisionWorld::rayTest, one collision object for each shape.
RayCasting bullet_ray_test(const std::vector<sim::Shape>& shapes);

/// rtcIntersect1 on the triangles of the simulator.
RayCasting embree(const std::vector<sim::Triangle>& triangles);

}  // namespace ribbon_mapper::bench
