// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Converts planes to an OctoMap (.bt, voxels of 5 cm, map frame). Voxels that an observed cell
/// touches are occupied; all others are unknown, as the model holds no free space.
std::string planes_to_octomap(const std::vector<Plane>& planes);

}  // namespace ribbon_mapper
