// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper {

/// The integer coordinates of a voxel (within +-10^6 voxels), packed into one number. The keys of
/// neighbouring voxels differ by constants.
using VoxelKey = std::uint64_t;

/// Number of bits of each coordinate in a VoxelKey.
constexpr int kVoxelKeyBits = 21;

/// Returns the key of the voxel that holds a point, given in units of voxels.
inline VoxelKey voxel_key(const Eigen::Vector3d& point) {
  constexpr std::int64_t mask = (1 << kVoxelKeyBits) - 1, middle = 1 << (kVoxelKeyBits - 1);
  VoxelKey key = 0;
  for (int i = 0; i < 3; ++i) {
    const auto coordinate = static_cast<std::int64_t>(point[i] + middle);  // positive: rounds down
    key = (key << kVoxelKeyBits) | static_cast<VoxelKey>(coordinate & mask);
  }
  return key;
}

/// Returns the key of the voxel that holds a point [m], for voxels of this side.
inline VoxelKey voxel_key(const Eigen::Vector3d& point, double voxel_m) {
  return voxel_key((1.0 / voxel_m) * point);
}

/// Calls function(key) for the voxel itself and its 26 neighbours.
template <typename Function>
void for_each_around(VoxelKey key, const Function& function) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        function(key + static_cast<VoxelKey>(dx) * (VoxelKey{1} << (2 * kVoxelKeyBits)) +
                 static_cast<VoxelKey>(dy) * (VoxelKey{1} << kVoxelKeyBits) +
                 static_cast<VoxelKey>(dz));
      }
    }
  }
}

}  // namespace ribbon_mapper
