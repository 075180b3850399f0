// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/PlaneArray.h>

#include <vector>

#include "eval/metrics/patch.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::eval {

/// Planes of the model as they were sent with their cells. How many points a cell has is not sent:
/// one each.
std::vector<Plane> planes_from(const PlaneArray& message);

/// Planes of the world.
std::vector<Patch> patches_from(const PlaneArray& message);

}  // namespace ribbon_mapper::eval
