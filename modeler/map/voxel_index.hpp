// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <tsl/robin_map.h>

#include "modeler/map/posed_ribbon.hpp"
#include "modeler/map/voxel_key.hpp"

namespace ribbon_mapper {

/// Which hypotheses are near a place: those that touch its voxel or one next to it. Those that
/// became a part of another stay entered; whose part they are is found out when somebody asks.
class VoxelIndex {
 public:
  explicit VoxelIndex(double voxel_m) : voxel_m_(voxel_m) {}

  /// Voxels that a ribbon goes through, in its own order, without repetition of neighbours; not
  /// those of which it cuts a corner only.
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
  using Slots = std::vector<std::uint32_t>;

  std::uint32_t whole_of(std::uint32_t slot);
  void replace_parts(Slots& slots);
  void append_slots_of(VoxelKey key, std::vector<std::uint32_t>& slots);

  double voxel_m_;
  tsl::robin_map<VoxelKey, Slots, KeyHash> slots_;  // that touch a voxel
  std::vector<std::vector<VoxelKey>> touched_;      // by slot, sorted
  std::vector<std::uint32_t> part_of_;              // by slot; itself if it is a whole
  std::vector<std::uint32_t> asked_;  // number of the last question that a slot answered
  std::uint32_t question_ = 0;
};

}  // namespace ribbon_mapper
