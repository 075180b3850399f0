// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstdlib>

#include "modeler/map/grid_keys.hpp"

namespace ribbon_mapper {

/// A voxel's place, 21 bits for each coordinate (+-10^6 voxels), offset so that the difference of
/// two keys is that of the places.
using VoxelKey = std::uint64_t;
constexpr int voxel_key_bits = 21;

inline VoxelKey voxel_key(const Eigen::Vector3d& point, double voxel_m) {
  const double voxels_per_m = 1.0 / voxel_m;
  VoxelKey key = 0;
  for (int i = 0; i < 3; ++i) {
    const auto place = floor_to_int(voxels_per_m * point[i]) + (1 << (voxel_key_bits - 1));
    key = (key << voxel_key_bits) | (static_cast<VoxelKey>(place) & ((1u << voxel_key_bits) - 1));
  }
  return key;
}

/// From one voxel to another.
struct VoxelStep {
  int x, y, z;
  bool is_to_neighbour() const { return std::abs(x) <= 1 && std::abs(y) <= 1 && std::abs(z) <= 1; }
};

inline VoxelStep step_between(VoxelKey from, VoxelKey to) {
  constexpr VoxelKey mask = (VoxelKey{1} << voxel_key_bits) - 1;
  const auto along = [&](int axis) {
    const int shift = (2 - axis) * voxel_key_bits;
    return static_cast<int>((to >> shift) & mask) - static_cast<int>((from >> shift) & mask);
  };
  return {along(0), along(1), along(2)};
}

/// Calls function(key) for the voxel itself and the 26 next to it, but those that are next to
/// `done` as well.
template <typename Function>
void for_each_around(VoxelKey key, VoxelKey done, const Function& function) {
  const VoxelStep from_done = step_between(done, key);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const VoxelStep step{from_done.x + dx, from_done.y + dy, from_done.z + dz};
        if (step.is_to_neighbour()) continue;
        function(key + static_cast<VoxelKey>(dx) * (VoxelKey{1} << (2 * voxel_key_bits)) +
                 static_cast<VoxelKey>(dy) * (VoxelKey{1} << voxel_key_bits) +
                 static_cast<VoxelKey>(dz));
      }
    }
  }
}

constexpr VoxelKey nowhere = 0;  ///< the corner of space, a million voxels away

}  // namespace ribbon_mapper
