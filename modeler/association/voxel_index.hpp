// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/geometry/cube_sides.hpp"
#include "modeler/geometry/shared_vector.hpp"
#include "modeler/geometry/voxel_key.hpp"
#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper {

/// Finds the hypotheses near a point or ribbon that were seen from a similar direction.
///
/// A hypothesis is near a voxel if it touches that voxel or one of the 26 around it. Queries are
/// far more frequent than changes, so each voxel lists all hypotheses near it. Hypotheses are known
/// by their slots, and voxels by numbers in the order of their creation.
class VoxelIndex {
 public:
  /// Creates an empty index of voxels with this side.
  explicit VoxelIndex(double voxel_m) : voxel_m_(voxel_m) {}

  /// Returns the voxel that holds a point [m]. Creates it if necessary.
  std::uint32_t voxel_at(const Eigen::Vector3d& point);

  /// Sets `voxels` to those that a ribbon passes through, in its order, each once in succession.
  /// Voxels of which it only cuts a corner may be missing.
  void voxels_of(const PosedRibbon& ribbon, std::vector<std::uint32_t>& voxels);

  /// Lists a hypothesis for further sides of a cube. Must be called before enter().
  void list(std::uint32_t slot, CubeSides sides);
  /// Adds voxels to those that a hypothesis touches.
  void enter(std::uint32_t slot, const std::vector<std::uint32_t>& voxels);
  /// Removes a hypothesis and returns the voxels that it touched. Its slot may be used again.
  std::vector<std::uint32_t> remove(std::uint32_t slot);

  /// Sets `slots` to the hypotheses near any of the voxels that are listed for `side` and for which
  /// accepts(slot) is true, each once.
  template <typename Accepts>
  void near(const std::vector<std::uint32_t>& voxels, int side, const Accepts& accepts,
            std::vector<std::uint32_t>& slots) {
    slots.clear();
    ++query_;
    for (const std::uint32_t voxel : voxels) {
      const std::vector<std::uint32_t>& listed = voxels_[voxel].near[side];
      if (accepted_.size() < listed.size()) accepted_.resize(2 * listed.size());
      std::size_t count = 0;  // without branches, which would be unpredictable
      for (const std::uint32_t slot : listed) {
        accepted_[count] = slot;
        count += accepts(slot) ? 1 : 0;
      }
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t slot = accepted_[i];
        if (slot_queries_[slot] == query_) continue;
        slot_queries_[slot] = query_;
        slots.push_back(slot);
      }
    }
  }

  /// Returns the voxels that a hypothesis touches, in ascending order.
  const std::vector<std::uint32_t>& touched_by(std::uint32_t slot) const {
    return entries_[slot].touched;
  }
  /// Returns the memory in use. Visits every voxel.
  std::size_t memory_bytes() const;

 private:
  struct Voxel {
    VoxelKey key{};
    std::vector<std::uint32_t> slots;                         // hypotheses that touch it
    std::vector<std::uint32_t> around;                        // itself and its neighbours
    std::array<std::vector<std::uint32_t>, kCubeSides> near;  // hypotheses near it, by side
    std::size_t memory_bytes() const;
  };
  struct Entry {
    std::vector<std::uint32_t> touched;  // voxels, sorted
    CubeSides sides = 0;
    std::size_t memory_bytes() const;
  };

 public:
  /// A state of the index. It shares with the index what has not changed since.
  class State {
    friend class VoxelIndex;
    SharedVector<Voxel> voxels_;
    SharedVector<Entry> entries_;
  };
  /// Returns the present state.
  State state() const;
  /// Returns to a former state of this index, or of the index that it was copied from.
  void restore(const State& state);
  /// Returns the memory of what `state` has and `later` does not share.
  static std::size_t unshared_bytes(const State& state, const State& later);

 private:
  std::uint32_t voxel_of(VoxelKey key);
  void list_hypotheses_near(Voxel& voxel);
  void add_touched(std::uint32_t slot, std::uint32_t voxel, std::ptrdiff_t position);
  static void list_at(Voxel& voxel, std::uint32_t slot, CubeSides sides);
  template <typename Function>
  void for_each_voxel_around(const std::vector<std::uint32_t>& voxels, const Function& function);

  double voxel_m_;
  tsl::robin_map<VoxelKey, std::uint32_t, KeyHash> numbers_;  // of voxels
  SharedVector<Voxel> voxels_;
  SharedVector<Entry> entries_;                              // by slot
  std::uint32_t query_ = 0;                                  // number of the latest query
  std::vector<std::uint32_t> voxel_queries_, slot_queries_;  // the last one that met each
  std::vector<std::uint32_t> accepted_, added_;              // working memory
};

}  // namespace ribbon_mapper
