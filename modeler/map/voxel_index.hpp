// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "modeler/map/posed_ribbon.hpp"

namespace ribbon_mapper {

using VoxelKey = std::uint64_t;

/// Which hypotheses are near a place. A hypothesis is entered in every voxel that it touches and in
/// those next to it, so asking is one look-up per voxel.
class VoxelIndex {
 public:
  explicit VoxelIndex(double voxel_m) : voxel_m_(voxel_m) {}

  VoxelKey key_of(const Eigen::Vector3d& point) const;

  /// Voxels that a ribbon goes through, in its own order, without repetition of neighbours.
  void voxels_of(const PosedRibbon& ribbon, std::vector<VoxelKey>& keys) const;

  /// Enters a hypothesis (its slot) at the voxels that it is not yet entered for.
  void enter(std::uint32_t slot, const std::vector<VoxelKey>& keys);
  /// `from` becomes a part of `into`.
  void unite(std::uint32_t into, std::uint32_t from);

  /// Slots near any of the voxels, each once.
  void near(const std::vector<VoxelKey>& keys, std::vector<std::uint32_t>& slots);

  const std::vector<VoxelKey>& touched_by(std::uint32_t slot) const { return touched_[slot]; }
  std::size_t memory_bytes() const;

 private:
  double voxel_m_;
  std::unordered_map<VoxelKey, std::vector<std::uint32_t>> slots_;  // near a voxel
  std::vector<std::vector<VoxelKey>> touched_;                      // by slot, sorted
  std::vector<std::uint32_t> asked_;  // number of the last question that a slot answered
  std::uint32_t question_ = 0;
};

}  // namespace ribbon_mapper
