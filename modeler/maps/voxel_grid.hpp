// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper {

/// The integer coordinates of a voxel: it covers [i, i + 1) voxels along each axis.
using MapVoxel = std::array<std::int32_t, 3>;

/// Returns the voxel that holds a point, given in units of voxels.
inline MapVoxel voxel_at(const Eigen::Vector3f& point) {
  return {floor_to_int(point.x()), floor_to_int(point.y()), floor_to_int(point.z())};
}

/// A byte for each voxel of space, 0 where nothing was written. Memory is taken in blocks of 16^3
/// voxels. Coordinates lie within +-16 million voxels.
class VoxelGrid {
 public:
  static constexpr int kBlockBits = 4;  ///< side of a block: 16
  static constexpr std::size_t kBlockSize = std::size_t{1} << 3 * kBlockBits;  ///< bytes of a block

  /// Returns the byte of a voxel to be changed.
  std::uint8_t& at(const MapVoxel& voxel) {
    if (!is_in_last_block(voxel)) find_or_add(voxel);
    return blocks_[last_block_][offset_of(voxel)];
  }

  /// Returns the byte of a voxel.
  std::uint8_t operator[](const MapVoxel& voxel) const {
    const auto found = index_.find(block_key(voxel));
    return found == index_.end() ? std::uint8_t{0} : blocks_[found->second][offset_of(voxel)];
  }

  /// Calls function(voxel, byte) for each voxel that is not 0, block by block in a fixed order.
  template <typename Function>
  void for_each(const Function& function) const {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(index_.begin(), index_.end());
    std::sort(order.begin(), order.end());
    for (const auto& [key, block] : order) {
      const MapVoxel corner = corner_of(key);
      for (std::size_t i = 0; i < kBlockSize; ++i) {
        const std::uint8_t value = blocks_[block][i];
        if (value != 0) function(voxel_in(corner, static_cast<std::int32_t>(i)), value);
      }
    }
  }

  /// Replaces each byte by function(voxel, byte).
  template <typename Function>
  void change(const Function& function) {
    for (const auto& [key, block] : index_) {
      const MapVoxel corner = corner_of(key);
      for (std::size_t i = 0; i < kBlockSize; ++i) {
        std::uint8_t& value = blocks_[block][i];
        value = function(voxel_in(corner, static_cast<std::int32_t>(i)), value);
      }
    }
  }

  /// Returns the memory in use.
  std::size_t memory_bytes() const {
    return blocks_.capacity() * kBlockSize +
           index_.bucket_count() * (sizeof(std::uint64_t) + sizeof(std::uint64_t));
  }

 private:
  static constexpr int kKeyBits = 21;
  static constexpr std::int32_t kKeyMiddle = 1 << (kKeyBits - 1);
  static constexpr std::int32_t kMask = (1 << kBlockBits) - 1;
  using Block = std::array<std::uint8_t, kBlockSize>;

  static std::uint64_t block_key(const MapVoxel& voxel) {
    std::uint64_t key = 0;
    for (const std::int32_t i : voxel) {
      const std::int32_t block = (i >> kBlockBits) + kKeyMiddle;
      key = (key << kKeyBits) | (static_cast<std::uint64_t>(block) & ((1U << kKeyBits) - 1U));
    }
    return key;
  }
  static std::size_t offset_of(const MapVoxel& voxel) {
    return static_cast<std::size_t>(((voxel[0] & kMask) << 2 * kBlockBits) |
                                    ((voxel[1] & kMask) << kBlockBits) | (voxel[2] & kMask));
  }
  static MapVoxel corner_of(std::uint64_t key) {
    MapVoxel corner{};
    for (std::size_t axis = 3; axis-- > 0; key >>= kKeyBits) {
      const auto block = static_cast<std::int32_t>(key & ((1U << kKeyBits) - 1U)) - kKeyMiddle;
      corner[axis] = block * (1 << kBlockBits);
    }
    return corner;
  }
  static MapVoxel voxel_in(const MapVoxel& corner, std::int32_t offset) {
    return {corner[0] + (offset >> 2 * kBlockBits), corner[1] + (offset >> kBlockBits & kMask),
            corner[2] + (offset & kMask)};
  }
  bool is_in_last_block(const MapVoxel& voxel) const {
    const std::int32_t difference =
        (voxel[0] ^ last_voxel_[0]) | (voxel[1] ^ last_voxel_[1]) | (voxel[2] ^ last_voxel_[2]);
    return (difference >> kBlockBits) == 0 && !blocks_.empty();
  }
  void find_or_add(const MapVoxel& voxel) {
    const std::uint64_t key = block_key(voxel);
    const auto found = index_.find(key);
    if (found == index_.end()) {
      blocks_.push_back({});
      last_block_ = static_cast<std::uint32_t>(blocks_.size() - 1);
      index_.emplace(key, last_block_);
    } else {
      last_block_ = found->second;
    }
    last_voxel_ = voxel;
  }

  tsl::robin_map<std::uint64_t, std::uint32_t, KeyHash> index_;
  std::vector<Block> blocks_;
  MapVoxel last_voxel_{};  // neighbours are written one after the other
  std::uint32_t last_block_ = 0;
};

}  // namespace ribbon_mapper
