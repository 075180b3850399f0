// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/voxel_index.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ribbon_mapper {
namespace {

constexpr double steps_per_voxel = 8.0;  // along a ribbon
constexpr int bits = 21;  // of each coordinate: +-10^6 voxels
constexpr std::int64_t bias = std::int64_t{1} << (bits - 1);  // so that neighbours differ by sums
constexpr VoxelKey mask = (VoxelKey{1} << bits) - 1;

VoxelKey pack(std::int64_t x, std::int64_t y, std::int64_t z) {
  return ((static_cast<VoxelKey>(x + bias) & mask) << (2 * bits)) |
         ((static_cast<VoxelKey>(y + bias) & mask) << bits) |
         (static_cast<VoxelKey>(z + bias) & mask);
}

/// From one voxel to another.
struct Step {
  int x, y, z;
  bool is_short() const { return std::abs(x) <= 1 && std::abs(y) <= 1 && std::abs(z) <= 1; }
};

Step step_between(VoxelKey from, VoxelKey to) {
  const auto along = [&](int shift) {
    return static_cast<int>((to >> shift) & mask) - static_cast<int>((from >> shift) & mask);
  };
  return {along(2 * bits), along(bits), along(0)};
}

/// Calls function(key) for the voxel itself and the 26 next to it, but those that are next to
/// `done` as well.
template <typename Function>
void for_each_around(VoxelKey key, VoxelKey done, const Function& function) {
  const Step from_done = step_between(done, key);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        if (Step{from_done.x + dx, from_done.y + dy, from_done.z + dz}.is_short()) continue;
        function(key + static_cast<VoxelKey>(dx) * (VoxelKey{1} << (2 * bits)) +
                 static_cast<VoxelKey>(dy) * (VoxelKey{1} << bits) + static_cast<VoxelKey>(dz));
      }
    }
  }
}

constexpr VoxelKey nowhere = 0;  // the corner of space, a million voxels away

}  // namespace

VoxelKey VoxelIndex::key_of(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d place = (point / voxel_m_).array().floor();
  return pack(static_cast<std::int64_t>(place.x()), static_cast<std::int64_t>(place.y()),
              static_cast<std::int64_t>(place.z()));
}

void VoxelIndex::voxels_of(const PosedRibbon& ribbon, std::vector<VoxelKey>& keys) const {
  keys.clear();
  const RibbonSamples& samples = ribbon.ribbon->samples;
  const double from_m = samples.start_m, length_m = samples.length_m();
  const int steps = static_cast<int>(std::ceil(steps_per_voxel * length_m / voxel_m_));
  const double step_m = steps > 0 ? length_m / steps : 0.0;
  for (int i = 0; i <= steps; ++i) {
    const VoxelKey key = key_of(ribbon.centroid + (from_m + i * step_m) * ribbon.along);
    if (keys.empty() || keys.back() != key) keys.push_back(key);
  }
}

void VoxelIndex::enter(std::uint32_t slot, const std::vector<VoxelKey>& keys) {
  while (touched_.size() <= slot) {
    part_of_.push_back(static_cast<std::uint32_t>(touched_.size()));
    touched_.emplace_back();
    asked_.push_back(0);
  }
  std::vector<VoxelKey>& touched = touched_[slot];
  for (const VoxelKey key : keys) {
    const auto place = std::lower_bound(touched.begin(), touched.end(), key);
    if (place != touched.end() && *place == key) continue;
    touched.insert(place, key);
    slots_[key].push_back(slot);
  }
}

void VoxelIndex::unite(std::uint32_t into, std::uint32_t from) {
  part_of_[from] = into;
  std::vector<VoxelKey>& touched = touched_[into];
  const auto middle = static_cast<std::ptrdiff_t>(touched.size());
  touched.insert(touched.end(), touched_[from].begin(), touched_[from].end());
  std::inplace_merge(touched.begin(), touched.begin() + middle, touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  touched_[from] = {};
}

std::uint32_t VoxelIndex::whole_of(std::uint32_t slot) {
  while (part_of_[slot] != slot) slot = part_of_[slot] = part_of_[part_of_[slot]];
  return slot;
}

/// Each whole once, in the order of first appearance.
void VoxelIndex::replace_parts(Slots& slots) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t whole = whole_of(slots[i]);
    const auto end = slots.begin() + static_cast<std::ptrdiff_t>(kept);
    if (std::find(slots.begin(), end, whole) == end) slots[kept++] = whole;
  }
  slots.resize(kept);
}

void VoxelIndex::near(const std::vector<VoxelKey>& keys, std::vector<std::uint32_t>& slots) {
  slots.clear();
  ++question_;
  VoxelKey last = nowhere;
  for (const VoxelKey key : keys) {
    for_each_around(key, last, [&](VoxelKey around) { append_slots_of(around, slots); });
    last = key;
  }
}

/// Those that the question was not yet answered with.
void VoxelIndex::append_slots_of(VoxelKey key, std::vector<std::uint32_t>& slots) {
  const auto found = slots_.find(key);
  if (found == slots_.end()) return;
  Slots& here = found.value();
  const auto is_part = [this](std::uint32_t slot) { return part_of_[slot] != slot; };
  if (std::any_of(here.begin(), here.end(), is_part)) replace_parts(here);
  for (const std::uint32_t slot : here) {
    if (asked_[slot] == question_) continue;
    asked_[slot] = question_;
    slots.push_back(slot);
  }
}

std::size_t VoxelIndex::memory_bytes() const {
  std::size_t bytes = slots_.bucket_count() * (sizeof(VoxelKey) + sizeof(Slots) + 8) +
                      part_of_.capacity() * 2 * sizeof(std::uint32_t);
  for (const auto& [key, slots] : slots_) bytes += slots.capacity() * sizeof(slots[0]);
  for (const auto& keys : touched_) bytes += sizeof(keys) + keys.capacity() * sizeof(VoxelKey);
  return bytes;
}

}  // namespace ribbon_mapper
