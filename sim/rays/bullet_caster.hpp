// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim/rays/ray_caster.hpp"

namespace ribbon_mapper::sim {

/// Returns a caster that asks Bullet, in double precision: one static triangle mesh with an
/// unquantised tree. Bullet widens each triangle by 1e-4 of its height over each edge. So a
/// ray hits a 10 m wall up to 1 mm beyond its outer edge. Of surfaces in the same place, any may be
/// reported.
std::unique_ptr<const RayCaster> make_bullet_caster(const std::vector<Triangle>& triangles);

}  // namespace ribbon_mapper::sim
