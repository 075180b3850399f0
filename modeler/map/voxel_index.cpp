// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/voxel_index.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

constexpr double steps_per_voxel = 8.0;  // along a ribbon

}  // namespace

void VoxelIndex::voxels_of(const PosedRibbon& ribbon, std::vector<VoxelKey>& keys) const {
  keys.clear();
  const RibbonSamples& samples = ribbon.ribbon->samples;
  const double from_m = samples.start_m, length_m = samples.length_m();
  const int steps = static_cast<int>(std::ceil(steps_per_voxel * length_m / voxel_m_));
  const double step_m = steps > 0 ? length_m / steps : 0.0;
  for (int i = 0; i <= steps; ++i) {
    const VoxelKey key =
        voxel_key(ribbon.centroid + (from_m + i * step_m) * ribbon.along, voxel_m_);
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
