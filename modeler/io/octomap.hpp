// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/io/model_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Converts planes to an OctoMap (.bt). Voxels that an observed cell touches are occupied; all
/// others are unknown, as the model holds no free space.
///
/// Positions are relative to the label's origin; comments of the header state run and origin.
/// Voxels have 5 cm, or as many times twice that as it takes to hold all planes: an OctoMap reaches
/// 32768 voxels far.
std::string planes_to_octomap(const std::vector<Plane>& planes, const ModelLabel& label = {});

}  // namespace ribbon_mapper
