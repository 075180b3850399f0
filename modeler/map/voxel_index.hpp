// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <vector>

#include "modeler/map/posed_ribbon.hpp"
#include "modeler/map/voxel_key.hpp"

namespace ribbon_mapper {

/// Which hypotheses are near a place: those that touch its voxel or one next to it. Voxels are
/// numbered as they are met and know those next to them. Hypotheses that became a part of another
/// stay entered; whose part they are is found out when somebody asks.
class VoxelIndex {
 public:
  explicit VoxelIndex(double voxel_m) : voxel_m_(voxel_m) {}

  std::uint32_t voxel_at(const Eigen::Vector3d& point);

  /// Voxels that a ribbon goes through, in its own order, without repetition of neighbours; not
  /// those of which it cuts a corner only.
  void voxels_of(const PosedRibbon& ribbon, std::vector<std::uint32_t>& voxels);

  /// Enters a hypothesis (its slot) at the voxels that it is not yet entered for.
  void enter(std::uint32_t slot, const std::vector<std::uint32_t>& voxels);
  /// `from` becomes a part of `into`.
  void unite(std::uint32_t into, std::uint32_t from);

  /// Slots near any of the voxels for which accepts(slot) is true, each once.
  template <typename Accepts>
  void near(const std::vector<std::uint32_t>& voxels, const Accepts& accepts,
            std::vector<std::uint32_t>& slots) {
    slots.clear();
    ++question_;
    for (const std::uint32_t voxel : voxels) {
      for (const std::uint32_t around : voxels_[voxel].around) {
        if (voxels_[around].question == question_) continue;
        voxels_[around].question = question_;
        for (const std::uint32_t slot : wholes_in(voxels_[around])) {
          if (!accepts(slot) || entries_[slot].question == question_) continue;
          entries_[slot].question = question_;
          slots.push_back(slot);
        }
      }
    }
  }

  const std::vector<std::uint32_t>& touched_by(std::uint32_t slot) const {
    return entries_[slot].touched;
  }
  std::size_t memory_bytes() const;

 private:
  struct Voxel {
    std::vector<std::uint32_t> slots;   // that touch it
    std::vector<std::uint32_t> around;  // voxels: itself and those next to it
    std::uint32_t question = 0;         // the last one that it answered
    bool has_parts = false;             // among its slots
  };
  struct Entry {
    std::vector<std::uint32_t> touched;  // sorted
    std::uint32_t part_of;               // itself if it is a whole
    std::uint32_t question = 0;
  };

  std::uint32_t voxel_of(VoxelKey key);
  std::uint32_t whole_of(std::uint32_t slot);
  const std::vector<std::uint32_t>& wholes_in(Voxel& voxel) {
    if (voxel.has_parts) replace_parts(voxel);
    return voxel.slots;
  }
  void replace_parts(Voxel& voxel);

  double voxel_m_;
  tsl::robin_map<VoxelKey, std::uint32_t, KeyHash> numbers_;  // of voxels
  std::vector<Voxel> voxels_;
  std::vector<Entry> entries_;  // by slot
  std::uint32_t question_ = 0;
};

}  // namespace ribbon_mapper
