// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/voxel_index.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/sparing_vector.hpp"

namespace ribbon_mapper {
namespace {

constexpr double steps_per_voxel = 4.0;  // along a ribbon

}  // namespace

std::uint32_t VoxelIndex::voxel_of(VoxelKey key) {
  const auto number = static_cast<std::uint32_t>(voxels_.size());
  const auto [found, is_new] = numbers_.try_emplace(key, number);
  if (!is_new) return found->second;
  voxels_.emplace_back();
  for_each_around(key, [&](VoxelKey around) {
    const auto other = numbers_.find(around);
    if (other == numbers_.end()) return;
    voxels_[number].around.push_back(other->second);
    if (other->second != number) voxels_[other->second].around.push_back(number);
  });
  return number;
}

std::uint32_t VoxelIndex::voxel_at(const Eigen::Vector3d& point) {
  return voxel_of(voxel_key(point, voxel_m_));
}

void VoxelIndex::voxels_of(const PosedRibbon& ribbon, std::vector<std::uint32_t>& voxels) {
  voxels.clear();
  const RibbonSamples& samples = ribbon.ribbon->samples;
  const double from_m = samples.start_m, length_m = samples.length_m();
  const int steps = static_cast<int>(std::ceil(steps_per_voxel * length_m / voxel_m_));
  const double step_m = steps > 0 ? length_m / steps : 0.0;
  VoxelKey last{};
  for (int i = 0; i <= steps; ++i) {
    const VoxelKey key =
        voxel_key(ribbon.centroid + (from_m + i * step_m) * ribbon.along, voxel_m_);
    if (i == 0 || key != last) voxels.push_back(voxel_of(key));
    last = key;
  }
}

void VoxelIndex::enter(std::uint32_t slot, const std::vector<std::uint32_t>& voxels) {
  while (entries_.size() <= slot) {
    grow_sparingly(entries_);
    entries_.push_back({{}, static_cast<std::uint32_t>(entries_.size()), 0});
  }
  std::vector<std::uint32_t>& touched = entries_[slot].touched;
  if (touched.empty()) touched.reserve(4);
  for (const std::uint32_t voxel : voxels) {
    const auto place = std::lower_bound(touched.begin(), touched.end(), voxel);
    if (place != touched.end() && *place == voxel) continue;
    touched.insert(place, voxel);
    voxels_[voxel].slots.push_back(slot);
  }
}

void VoxelIndex::unite(std::uint32_t into, std::uint32_t from) {
  entries_[from].part_of = into;
  std::vector<std::uint32_t>& touched = entries_[into].touched;
  const std::vector<std::uint32_t> more = std::move(entries_[from].touched);
  for (const std::uint32_t voxel : more) voxels_[voxel].has_parts = true;
  entries_[from].touched = {};
  const auto middle = static_cast<std::ptrdiff_t>(touched.size());
  touched.insert(touched.end(), more.begin(), more.end());
  std::inplace_merge(touched.begin(), touched.begin() + middle, touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
}

std::uint32_t VoxelIndex::whole_of(std::uint32_t slot) {
  while (entries_[slot].part_of != slot) {
    slot = entries_[slot].part_of = entries_[entries_[slot].part_of].part_of;
  }
  return slot;
}

/// Each whole once, in the order of first appearance.
void VoxelIndex::replace_parts(Voxel& voxel) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < voxel.slots.size(); ++i) {
    const std::uint32_t whole = whole_of(voxel.slots[i]);
    const auto end = voxel.slots.begin() + static_cast<std::ptrdiff_t>(kept);
    if (std::find(voxel.slots.begin(), end, whole) == end) voxel.slots[kept++] = whole;
  }
  voxel.slots.resize(kept);
  voxel.has_parts = false;
}

std::size_t VoxelIndex::memory_bytes() const {
  std::size_t bytes = numbers_.bucket_count() * (sizeof(VoxelKey) + 2 * sizeof(std::uint64_t)) +
                      voxels_.capacity() * sizeof(Voxel) + entries_.capacity() * sizeof(Entry);
  for (const Voxel& voxel : voxels_) {
    bytes += (voxel.slots.capacity() + voxel.around.capacity()) * sizeof(std::uint32_t);
  }
  for (const Entry& entry : entries_) bytes += entry.touched.capacity() * sizeof(std::uint32_t);
  return bytes;
}

}  // namespace ribbon_mapper
