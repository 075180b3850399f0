// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// The surfaces as an OctoMap (.bt, voxels of 5 cm, map frame): every voxel that a seen cell
/// touches is occupied. What is free is not in the model, so it stays unknown.
std::string planes_to_octomap(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
