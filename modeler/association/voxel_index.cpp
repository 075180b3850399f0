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
  Voxel voxel;
  voxel.key = key;
  for_each_around(key, [&](VoxelKey around) {
    const auto other = numbers_.find(around);
    if (other == numbers_.end()) return;
    voxel.around.push_back(other->second);
    if (other->second != number) voxels_.edit(other->second).around.push_back(number);
  });
  voxels_.push_back(std::move(voxel));
  voxel_queries_.push_back(0);
  list_hypotheses_near(voxels_.edit(number));
  return number;
}

/// Fills the lists of a new voxel.
void VoxelIndex::list_hypotheses_near(Voxel& voxel) {
  ++query_;
  for (const std::uint32_t around : voxel.around) {
    for (const std::uint32_t slot : voxels_[around].slots) {
      if (slot_queries_[slot] == query_) continue;
      slot_queries_[slot] = query_;
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

/// Calls function(voxel) for the numbers of these voxels and their neighbours, each once.
template <typename Function>
void VoxelIndex::for_each_voxel_around(const std::vector<std::uint32_t>& voxels,
                                       const Function& function) {
  ++query_;
  for (const std::uint32_t voxel : voxels) {
    for (const std::uint32_t around : voxels_[voxel].around) {
      if (voxel_queries_[around] == query_) continue;
      voxel_queries_[around] = query_;
      function(around);
    }
  }
}

void VoxelIndex::list(std::uint32_t slot, CubeSides sides) {
  while (entries_.size() <= slot) {
    entries_.push_back({});
    slot_queries_.push_back(0);
  }
  const auto more = static_cast<CubeSides>(sides & ~entries_[slot].sides);
  if (more == 0) return;
  Entry& entry = entries_.edit(slot);
  for_each_voxel_around(entry.touched,
                        [&](std::uint32_t voxel) { list_at(voxels_.edit(voxel), slot, more); });
  entry.sides |= more;
}

void VoxelIndex::enter(std::uint32_t slot, const std::vector<std::uint32_t>& voxels) {
  const std::vector<std::uint32_t>* touched = &entries_[slot].touched;
  const bool is_new = touched->empty();
  added_.clear();
  for (const std::uint32_t voxel : voxels) {
    const auto position = std::lower_bound(touched->begin(), touched->end(), voxel);
    if (position != touched->end() && *position == voxel) continue;
    add_touched(slot, voxel, position - touched->begin());
    touched = &entries_[slot].touched;
  }
  if (added_.empty()) return;
  const CubeSides sides = entries_[slot].sides;
  const int side = first_side(sides);
  for_each_voxel_around(added_, [&](std::uint32_t voxel) {
    if (is_new || !holds(voxels_[voxel].near[side], slot)) {
      list_at(voxels_.edit(voxel), slot, sides);
    }
  });
}

/// Adds a voxel to those that a hypothesis touches, at this position among them.
void VoxelIndex::add_touched(std::uint32_t slot, std::uint32_t voxel, std::ptrdiff_t position) {
  std::vector<std::uint32_t>& touched = entries_.edit(slot).touched;
  if (touched.empty()) touched.reserve(4);
  touched.insert(touched.begin() + position, voxel);
  voxels_.edit(voxel).slots.push_back(slot);
  added_.push_back(voxel);
}

std::vector<std::uint32_t> VoxelIndex::remove(std::uint32_t slot) {
  const Entry entry = std::move(entries_.edit(slot));
  entries_.edit(slot) = {};
  for_each_voxel_around(entry.touched, [&](std::uint32_t number) {
    Voxel& voxel = voxels_.edit(number);
    for_each_side(entry.sides, [&](int side) { remove_from(voxel.near[side], slot); });
  });
  for (const std::uint32_t voxel : entry.touched) remove_from(voxels_.edit(voxel).slots, slot);
  return entry.touched;
}

VoxelIndex::State VoxelIndex::state() const {
  State state;
  state.voxels_ = voxels_, state.entries_ = entries_;
  return state;
}

void VoxelIndex::restore(const State& state) {
  for (std::size_t i = state.voxels_.size(); i < voxels_.size(); ++i) {
    numbers_.erase(voxels_[i].key);
  }
  voxels_ = state.voxels_, entries_ = state.entries_;
  voxel_queries_.resize(voxels_.size()), slot_queries_.resize(entries_.size());
}

std::size_t VoxelIndex::unshared_bytes(const State& state, const State& later) {
  std::size_t bytes = state.voxels_.memory_bytes() + state.entries_.memory_bytes();
  const auto count = [&bytes](const auto& element) { bytes += element.memory_bytes(); };
  state.voxels_.for_each_unshared(later.voxels_, count);
  state.entries_.for_each_unshared(later.entries_, count);
  return bytes;
}

std::size_t VoxelIndex::Voxel::memory_bytes() const {
  std::size_t elements = slots.capacity() + around.capacity();
  for (const auto& list : near) elements += list.capacity();
  return sizeof(Voxel) + elements * sizeof(std::uint32_t);
}

std::size_t VoxelIndex::Entry::memory_bytes() const {
  return sizeof(Entry) + touched.capacity() * sizeof(std::uint32_t);
}

std::size_t VoxelIndex::memory_bytes() const {
  return numbers_.bucket_count() * (sizeof(VoxelKey) + 2 * sizeof(std::uint64_t)) +
         (voxel_queries_.capacity() + slot_queries_.capacity()) * sizeof(std::uint32_t) +
         unshared_bytes(state(), {});
}

}  // namespace ribbon_mapper
