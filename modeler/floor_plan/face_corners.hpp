// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/wall_face.hpp"

namespace ribbon_mapper {

/// Moves the ends of faces that nearly meet in a corner into it. An end moves by up to
/// FloorPlanConfig::joint_m, and by up to overshoot_m if it lies before the other face, where
/// nothing is. Where there are several corners, it moves into the nearest one.
void fit_corners(std::vector<WallFace>& faces, const FloorPlanConfig& config);

}  // namespace ribbon_mapper
