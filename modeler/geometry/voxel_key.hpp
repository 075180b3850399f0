// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper {

/// A voxel's place, 21 bits for each coordinate (+-10^6 voxels), offset so that the difference of
/// two keys is that of the places.
using VoxelKey = std::uint64_t;
constexpr int kVoxelKeyBits = 21;

/// Of a point in units of voxels.
inline VoxelKey voxel_key(const Eigen::Vector3d& point) {
  constexpr std::int64_t mask = (1 << kVoxelKeyBits) - 1, middle = 1 << (kVoxelKeyBits - 1);
  VoxelKey key = 0;
  for (int i = 0; i < 3; ++i) {
    const auto place = static_cast<std::int64_t>(point[i] + middle);  // positive: rounds down
    key = (key << kVoxelKeyBits) | static_cast<VoxelKey>(place & mask);
  }
  return key;
}

inline VoxelKey voxel_key(const Eigen::Vector3d& point, double voxel_m) {
  return voxel_key((1.0 / voxel_m) * point);
}

/// Calls function(key) for the voxel itself and the 26 next to it.
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
