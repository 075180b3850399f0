// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/maps/maps_config.hpp"
#include "modeler/maps/sight_lines.hpp"
#include "modeler/maps/voxel_grid.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What is known of a voxel.
enum class VoxelState : std::uint8_t {
  unknown = 0,   ///< no beam came here
  free = 1,      ///< a beam passed
  occupied = 2,  ///< a plane, or a thing that is no plane
};

/// Which voxels are free and which are occupied. All others are unknown.
class VoxelMap {
 public:
  /// Creates a map of a grid that holds states alone.
  VoxelMap(double voxel_m, const Eigen::Vector3d& origin, VoxelGrid states)
      : voxel_m_(voxel_m), origin_(origin), states_(std::move(states)) {}

  /// Returns the side of a voxel [m].
  double voxel_m() const { return voxel_m_; }
  /// Returns the corner of voxel (0, 0, 0), in map [m].
  const Eigen::Vector3d& origin() const { return origin_; }
  /// Returns the state of a voxel.
  VoxelState operator[](const MapVoxel& voxel) const {
    return static_cast<VoxelState>(states_[voxel]);
  }
  /// Calls function(voxel, state) for each voxel that is not unknown, in a fixed order.
  template <typename Function>
  void for_each(const Function& function) const {
    states_.for_each([&](const MapVoxel& voxel, std::uint8_t state) {
      function(voxel, static_cast<VoxelState>(state));
    });
  }
  /// Returns the memory in use.
  std::size_t memory_bytes() const { return states_.memory_bytes(); }

 private:
  double voxel_m_;
  Eigen::Vector3d origin_;
  VoxelGrid states_;
};

/// Carves free space into a map of the planes and of the returns that belong to no plane.
///
/// A voxel of a seen cell is occupied. A voxel of loose returns is a matter of dispute between
/// lines that end in it and lines that pass it, decided as by OctoMap (Hornung et al. 2013): log
/// odds of hits and misses with its probabilities and limits. Any other voxel is free if a beam
/// passed it. `sights` must be of the same planes.
VoxelMap make_voxel_map(const std::vector<Plane>& planes, const SightLines& sights,
                        const MapsConfig& config);

}  // namespace ribbon_mapper
