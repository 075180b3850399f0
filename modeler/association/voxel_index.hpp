// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstdint>
#include <vector>

#include "modeler/geometry/cube_sides.hpp"
#include "modeler/geometry/voxel_key.hpp"
#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper {

/// Which hypotheses are near a place and look the same way: those that touch its voxel or one next
/// to it. Asked far more often than changed, so each voxel lists all that are near it. Voxels are
/// numbered as they are met and know those next to them.
class VoxelIndex {
 public:
  explicit VoxelIndex(double voxel_m) : voxel_m_(voxel_m) {}

  std::uint32_t voxel_at(const Eigen::Vector3d& point);

  /// Voxels that a ribbon goes through, in its own order, without repetition of neighbours; not
  /// those of which it cuts a corner only.
  void voxels_of(const PosedRibbon& ribbon, std::vector<std::uint32_t>& voxels);

  /// Lists a hypothesis (its slot) for the sides that it is not yet listed for: at first of all.
  void list(std::uint32_t slot, CubeSides sides);
  /// Enters it at the voxels that it is not yet entered at.
  void enter(std::uint32_t slot, const std::vector<std::uint32_t>& voxels);
  /// Returns the voxels that a hypothesis was entered at; its slot is as good as new.
  std::vector<std::uint32_t> remove(std::uint32_t slot);

  /// Slots near any of the voxels that are listed for the side and for which accepts(slot) is
  /// true, each once.
  template <typename Accepts>
  void near(const std::vector<std::uint32_t>& voxels, int side, const Accepts& accepts,
            std::vector<std::uint32_t>& slots) {
    slots.clear();
    ++question_;
    for (const std::uint32_t voxel : voxels) {
      const std::vector<std::uint32_t>& listed = voxels_[voxel].near[side];
      if (accepted_.size() < listed.size()) accepted_.resize(2 * listed.size());
      std::size_t count = 0;  // without branches, which nobody could predict
      for (const std::uint32_t slot : listed) {
        accepted_[count] = slot;
        count += accepts(slot) ? 1 : 0;
      }
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t slot = accepted_[i];
        if (entries_[slot].question == question_) continue;
        entries_[slot].question = question_;
        slots.push_back(slot);
      }
    }
  }

  const std::vector<std::uint32_t>& touched_by(std::uint32_t slot) const {
    return entries_[slot].touched;
  }
  std::size_t memory_bytes() const;

 private:
  struct Voxel {
    std::vector<std::uint32_t> slots;                         // that touch it
    std::vector<std::uint32_t> around;                        // voxels: itself and those next to it
    std::array<std::vector<std::uint32_t>, kCubeSides> near;  // by side: slots that touch these
    std::uint32_t question = 0;                               // the last one that it answered
  };
  struct Entry {
    std::vector<std::uint32_t> touched;  // voxels, sorted
    std::uint32_t question = 0;
    CubeSides sides = 0;
  };

  std::uint32_t voxel_of(VoxelKey key);
  void list_what_is_near(Voxel& voxel);
  static void list_at(Voxel& voxel, std::uint32_t slot, CubeSides sides);
  template <typename Function>
  void for_each_voxel_around(const std::vector<std::uint32_t>& voxels, const Function& function);

  double voxel_m_;
  tsl::robin_map<VoxelKey, std::uint32_t, KeyHash> numbers_;  // of voxels
  std::vector<Voxel> voxels_;
  std::vector<Entry> entries_;  // by slot
  std::uint32_t question_ = 0;
  std::vector<std::uint32_t> accepted_, fresh_;  // scratch
};

}  // namespace ribbon_mapper
