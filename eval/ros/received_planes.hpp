// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ribbon_mapper/PlaneArray.h>

#include <vector>

#include "eval/metrics/patch.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::eval {

/// Converts planes of the model that were sent with their cells. Each cell gets one point, as
/// counts are not part of the message.
std::vector<Plane> planes_from(const PlaneArray& message);

/// Returns the labels of planes of the model, in their order.
std::vector<PlaneLabel> labels_from(const PlaneArray& message);

/// Converts planes of the world.
std::vector<Patch> patches_from(const PlaneArray& message);

}  // namespace ribbon_mapper::eval
