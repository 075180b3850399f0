// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/io/model_label.hpp"
#include "modeler/maps/voxel_map.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Converts planes to an OctoMap (.bt). Voxels that an observed cell touches are occupied; all
/// others are unknown.
///
/// Positions are relative to the label's origin; comments of the header state run and origin.
/// Voxels have 5 cm, or as many times twice that as it takes to hold all planes: an OctoMap reaches
/// 32768 voxels far.
std::string planes_to_octomap(const std::vector<Plane>& planes, const ModelLabel& label = {});

/// Converts a map of free and occupied voxels to an OctoMap (.bt). Positions are relative to the
/// map's origin, which must be that of the label.
std::string voxels_to_octomap(const VoxelMap& voxels, const ModelLabel& label = {});

/// Returns the part of that file after its header: the data of octomap_msgs/Octomap.
std::string octomap_data(const VoxelMap& voxels);

}  // namespace ribbon_mapper
