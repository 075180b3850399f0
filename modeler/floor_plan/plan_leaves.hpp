// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/floor_plan/plan_openings.hpp"

namespace ribbon_mapper {

/// Hangs each door leaf at the jamb that is nearest to one of its edges. Of the two faces of a
/// leaf, the wider one is kept.
void hang_leaves(const std::vector<Plane>& planes, const Semantics& semantics,
                 const FloorPlanConfig& config, std::vector<PlanOpening>& openings);

}  // namespace ribbon_mapper
