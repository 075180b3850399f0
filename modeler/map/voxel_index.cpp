// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/voxel_index.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {

constexpr int bits = 21;  // of each coordinate: +-10^6 voxels
constexpr VoxelKey mask = (VoxelKey{1} << bits) - 1;

VoxelKey pack(std::int64_t x, std::int64_t y, std::int64_t z) {
  return ((static_cast<VoxelKey>(x) & mask) << (2 * bits)) |
         ((static_cast<VoxelKey>(y) & mask) << bits) | (static_cast<VoxelKey>(z) & mask);
}

/// The voxel itself and the 26 next to it.
template <typename Function>
void for_each_around(VoxelKey key, const Function& function) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        function(pack(static_cast<std::int64_t>(key >> (2 * bits)) + dx,
                      static_cast<std::int64_t>(key >> bits) + dy,
                      static_cast<std::int64_t>(key) + dz));
      }
    }
  }
}

}  // namespace

VoxelKey VoxelIndex::key_of(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d place = (point / voxel_m_).array().floor();
  return pack(static_cast<std::int64_t>(place.x()), static_cast<std::int64_t>(place.y()),
              static_cast<std::int64_t>(place.z()));
}

void VoxelIndex::voxels_of(const PosedRibbon& ribbon, std::vector<VoxelKey>& keys) const {
  keys.clear();
  for (const RibbonSample& sample : ribbon.ribbon->samples) {
    const VoxelKey key = key_of(ribbon.T_world_base * sample.point.cast<double>());
    if (keys.empty() || keys.back() != key) keys.push_back(key);
  }
}

void VoxelIndex::enter(std::uint32_t slot, const std::vector<VoxelKey>& keys) {
  if (touched_.size() <= slot) touched_.resize(slot + 1), asked_.resize(slot + 1, 0);
  std::vector<VoxelKey>& touched = touched_[slot];
  for (const VoxelKey key : keys) {
    const auto place = std::lower_bound(touched.begin(), touched.end(), key);
    if (place != touched.end() && *place == key) continue;
    touched.insert(place, key);
    for_each_around(key, [&](VoxelKey near) {
      std::vector<std::uint32_t>& slots = slots_[near];
      if (std::find(slots.begin(), slots.end(), slot) == slots.end()) slots.push_back(slot);
    });
  }
}

void VoxelIndex::unite(std::uint32_t into, std::uint32_t from) {
  const std::vector<VoxelKey> keys = std::move(touched_[from]);
  touched_[from].clear();
  for (const VoxelKey key : keys) {
    for_each_around(key, [&](VoxelKey near) {
      std::vector<std::uint32_t>& slots = slots_[near];
      slots.erase(std::remove(slots.begin(), slots.end(), from), slots.end());
    });
  }
  enter(into, keys);
}

void VoxelIndex::near(const std::vector<VoxelKey>& keys, std::vector<std::uint32_t>& slots) {
  slots.clear();
  ++question_;
  for (const VoxelKey key : keys) {
    const auto found = slots_.find(key);
    if (found == slots_.end()) continue;
    for (const std::uint32_t slot : found->second) {
      if (asked_[slot] == question_) continue;
      asked_[slot] = question_;
      slots.push_back(slot);
    }
  }
}

std::size_t VoxelIndex::memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& [key, slots] : slots_) {
    bytes += sizeof(key) + sizeof(slots) + slots.capacity() * sizeof(slots[0]);
  }
  for (const auto& keys : touched_) bytes += sizeof(keys) + keys.capacity() * sizeof(VoxelKey);
  return bytes;
}

}  // namespace ribbon_mapper
