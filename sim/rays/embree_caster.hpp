// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim/rays/ray_caster.hpp"

namespace ribbon_mapper::sim {

/// Returns a caster that asks Embree for the first triangle, in single precision, and then
/// intersects the ray with that triangle's plane in double precision. Throws std::runtime_error if
/// Embree cannot be started.
std::unique_ptr<const RayCaster> make_embree_caster(const std::vector<Triangle>& triangles);

}  // namespace ribbon_mapper::sim
