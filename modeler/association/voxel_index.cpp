// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/voxel_index.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/vector_storage.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kStepsPerVoxel = 4.0;  // along a ribbon

/// Returns true if `slots` contain the slot. Searches from the end, where the recently entered ones
/// are, which are looked up most.
bool holds(const std::vector<std::uint32_t>& slots, std::uint32_t slot) {
  return std::find(slots.rbegin(), slots.rend(), slot) != slots.rend();
}

/// Removes a slot. Does not keep the order.
void remove_from(std::vector<std::uint32_t>& slots, std::uint32_t slot) {
  *std::find(slots.rbegin(), slots.rend(), slot) = slots.back();
  slots.pop_back();
}

}  // namespace

/// Returns the voxel of a key. Creates it if necessary and links it with its neighbours.
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
  list_hypotheses_near(voxels_[number]);
  return number;
}

/// Fills the lists of a new voxel.
void VoxelIndex::list_hypotheses_near(Voxel& voxel) {
  ++query_;
  for (const std::uint32_t around : voxel.around) {
    for (const std::uint32_t slot : voxels_[around].slots) {
      if (entries_[slot].query == query_) continue;
      entries_[slot].query = query_;
      list_at(voxel, slot, entries_[slot].sides);
    }
  }
}

void VoxelIndex::list_at(Voxel& voxel, std::uint32_t slot, CubeSides sides) {
  for_each_side(sides, [&](int side) {
    reserve_one_more(voxel.near[side]);
    voxel.near[side].push_back(slot);
  });
}

std::uint32_t VoxelIndex::voxel_at(const Eigen::Vector3d& point) {
  return voxel_of(voxel_key(point, voxel_m_));
}

void VoxelIndex::voxels_of(const PosedRibbon& ribbon, std::vector<std::uint32_t>& voxels) {
  voxels.clear();
  const double length = ribbon.ribbon->length_m / voxel_m_;  // in voxels, as all lengths here
  const int steps = static_cast<int>(std::ceil(kStepsPerVoxel * length));
  const Eigen::Vector3d start = ribbon.point(ribbon.ribbon->samples.start_m, 0.0F) / voxel_m_;
  const Eigen::Vector3d step = (steps > 0 ? length / steps : 0.0) * ribbon.along;
  VoxelKey last{};
  for (int i = 0; i <= steps; ++i) {
    const VoxelKey key = voxel_key(start + i * step);
    if (i == 0 || key != last) voxels.push_back(voxel_of(key));
    last = key;
  }
}

/// Calls function(voxel) for these voxels and their neighbours, each once.
template <typename Function>
void VoxelIndex::for_each_voxel_around(const std::vector<std::uint32_t>& voxels,
                                       const Function& function) {
  ++query_;
  for (const std::uint32_t voxel : voxels) {
    for (const std::uint32_t around : voxels_[voxel].around) {
      if (voxels_[around].query == query_) continue;
      voxels_[around].query = query_;
      function(voxels_[around]);
    }
  }
}

void VoxelIndex::list(std::uint32_t slot, CubeSides sides) {
  while (entries_.size() <= slot) {
    reserve_one_more(entries_);
    entries_.emplace_back();
  }
  Entry& entry = entries_[slot];
  const auto more = static_cast<CubeSides>(sides & ~entry.sides);
  if (more == 0) return;
  for_each_voxel_around(entry.touched, [&](Voxel& voxel) { list_at(voxel, slot, more); });
  entry.sides |= more;
}

void VoxelIndex::enter(std::uint32_t slot, const std::vector<std::uint32_t>& voxels) {
  Entry& entry = entries_[slot];
  std::vector<std::uint32_t>& touched = entry.touched;
  const bool is_new = touched.empty();
  if (is_new) touched.reserve(4);
  added_.clear();
  for (const std::uint32_t voxel : voxels) {
    const auto position = std::lower_bound(touched.begin(), touched.end(), voxel);
    if (position != touched.end() && *position == voxel) continue;
    touched.insert(position, voxel);
    voxels_[voxel].slots.push_back(slot);
    added_.push_back(voxel);
  }
  if (added_.empty()) return;
  const int side = first_side(entry.sides);
  for_each_voxel_around(added_, [&](Voxel& voxel) {
    if (is_new || !holds(voxel.near[side], slot)) list_at(voxel, slot, entry.sides);
  });
}

std::vector<std::uint32_t> VoxelIndex::remove(std::uint32_t slot) {
  const Entry entry = std::move(entries_[slot]);
  entries_[slot] = {};
  for_each_voxel_around(entry.touched, [&](Voxel& voxel) {
    for_each_side(entry.sides, [&](int side) { remove_from(voxel.near[side], slot); });
  });
  for (const std::uint32_t voxel : entry.touched) remove_from(voxels_[voxel].slots, slot);
  return entry.touched;
}

std::size_t VoxelIndex::memory_bytes() const {
  std::size_t bytes = numbers_.bucket_count() * (sizeof(VoxelKey) + 2 * sizeof(std::uint64_t)) +
                      voxels_.capacity() * sizeof(Voxel) + entries_.capacity() * sizeof(Entry);
  for (const Voxel& voxel : voxels_) {
    bytes += (voxel.slots.capacity() + voxel.around.capacity()) * sizeof(std::uint32_t);
    for (const auto& near : voxel.near) bytes += near.capacity() * sizeof(std::uint32_t);
  }
  for (const Entry& entry : entries_) bytes += entry.touched.capacity() * sizeof(std::uint32_t);
  return bytes;
}

}  // namespace ribbon_mapper
