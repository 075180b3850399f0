// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/plane_map.hpp"

#include <tsl/robin_set.h>

#include <algorithm>
#include <cmath>

#include "modeler/geometry/vector_storage.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::int64_t kNoId = -1;  // of a ribbon that is in no hypothesis

}  // namespace

PlaneMap::PlaneMap(double reach_m, const AssociationGates& gates, std::int64_t first_id)
    : gates_(gates),
      min_cosine_(static_cast<float>(min_cosine(gates)) - 1e-4F),
      max_distance_m_(static_cast<float>(gates.distance_m) + 1e-3F),
      reach_(std::sqrt(2.0 - 2.0 * min_cosine(gates)) + 1e-4),
      index_(reach_m),
      next_id_(first_id) {}

void PlaneMap::add(const PosedRibbon& ribbon, std::uint32_t index) {
  const Eigen::Vector3f normal = ribbon.normal.cast<float>();
  const Eigen::Vector3f centroid = ribbon.centroid.cast<float>();
  const auto is_parallel = [&](std::uint32_t slot) {
    return float_planes_[slot].normal.dot(normal) >= min_cosine_;
  };
  const auto is_close = [&](std::uint32_t slot) {
    const FloatPlane& plane = float_planes_[slot];
    return std::abs(plane.normal.dot(centroid) + plane.d_m) <= max_distance_m_;
  };
  index_.voxels_of(ribbon, voxels_);
  index_.near(voxels_, cube_side(ribbon.normal), is_parallel, near_);
  std::optional<double> min_sigmas;
  std::uint32_t slot = 0;
  matches_.clear();
  for (const std::uint32_t candidate : near_) {
    if (!is_close(candidate)) continue;
    const auto sigmas = square_sigmas(ribbon, hypotheses_[candidate], gates_);
    if (!sigmas) continue;
    matches_.push_back(candidate);
    if (!min_sigmas || *sigmas < *min_sigmas) min_sigmas = sigmas, slot = candidate;
  }
  if (!min_sigmas) slot = new_slot();
  const auto probability = static_cast<float>(membership(min_sigmas.value_or(0.0)));
  hypotheses_.edit(slot).add(ribbon, {index, probability});
  refresh(slot);
  index_.enter(slot, voxels_);
  if (matches_.size() > 1) merge_with(matches_, slot);
}

std::vector<const Hypothesis*> PlaneMap::near(const PosedRibbon& ribbon) {
  index_.voxels_of(ribbon, voxels_);
  index_.near(
      voxels_, cube_side(ribbon.normal), [](std::uint32_t) { return true; }, near_);
  std::vector<const Hypothesis*> found;
  for (const std::uint32_t slot : near_) found.push_back(&hypotheses_[slot]);
  return found;
}

std::uint32_t PlaneMap::new_slot() {
  const Hypothesis empty(created_++);
  const std::int64_t id = next_id_++;
  if (!free_slots_.empty()) {
    const std::uint32_t slot = free_slots_.back();
    free_slots_.pop_back();
    hypotheses_.edit(slot) = empty;
    ids_[slot] = id;
    return slot;
  }
  hypotheses_.push_back(empty);
  ids_.push_back(id);
  float_planes_.emplace_back();
  return static_cast<std::uint32_t>(hypotheses_.size() - 1);
}

/// Updates what is derived from a hypothesis' plane after a new fit.
void PlaneMap::refresh(std::uint32_t slot) {
  const Hypothesis& plane = hypotheses_[slot];
  float_planes_[slot] = {plane.normal().cast<float>(), static_cast<float>(plane.d_m())};
  index_.list(slot, cube_sides_within(plane.normal(), reach_));
}

/// Merges the hypothesis at `slot` with those of the matches that are one plane with it.
void PlaneMap::merge_with(const std::vector<std::uint32_t>& matches, std::uint32_t slot) {
  for (const std::uint32_t other : matches) {
    // A match may be gone: it was merged into a larger one before.
    if (other == slot || !is_alive(other)) continue;
    const bool is_larger = hypotheses_[slot].area_m2() >= hypotheses_[other].area_m2();
    const std::uint32_t larger = is_larger ? slot : other;
    const std::uint32_t smaller = is_larger ? other : slot;
    if (!are_one_plane(hypotheses_[larger], hypotheses_[smaller], gates_)) continue;
    merge(larger, smaller);
    slot = larger;
  }
}

/// Merges two hypotheses. The result has the older id.
void PlaneMap::merge(std::uint32_t into, std::uint32_t from) {
  const std::int64_t created = std::min(hypotheses_[into].id, hypotheses_[from].id);
  Hypothesis& merged = hypotheses_.edit(into);
  merged.absorb(hypotheses_[from]);
  merged.id = created;
  ids_[into] = std::min(ids_[into], ids_[from]);
  hypotheses_.edit(from) = Hypothesis(0);
  free_slots_.push_back(from);
  refresh(into);
  index_.enter(into, index_.remove(from));
}

std::vector<Hypothesis> PlaneMap::hypotheses() const {
  std::vector<Hypothesis> alive;
  for (std::uint32_t slot = 0; slot < hypotheses_.size(); ++slot) {
    if (!is_alive(slot)) continue;
    alive.push_back(hypotheses_[slot]);
    alive.back().id = ids_[slot];
  }
  std::sort(alive.begin(), alive.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.id < b.id; });
  return alive;
}

std::vector<Hypothesis> PlaneMap::merged_hypotheses() const {
  PlaneMap work = *this;
  std::vector<std::uint32_t> order;
  for (std::uint32_t slot = 0; slot < hypotheses_.size(); ++slot) {
    if (is_alive(slot)) order.push_back(slot);
  }
  std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return hypotheses_[a].area_m2() > hypotheses_[b].area_m2();
  });
  // A hypothesis is open until it was examined, and again when one near it has changed.
  std::vector<char> is_open(hypotheses_.size(), 1);
  bool changed = true;
  while (changed) {
    changed = false;
    for (const std::uint32_t slot : order) {
      if (!is_open[slot]) continue;
      is_open[slot] = 0;
      if (!work.absorb_neighbours(slot)) continue;
      changed = true;
      for (const std::uint32_t near : work.parallel_neighbours(slot)) is_open[near] = 1;
    }
  }
  return work.hypotheses();
}

/// Returns the slots near a hypothesis that may be one plane with it, including its own.
std::vector<std::uint32_t> PlaneMap::parallel_neighbours(std::uint32_t slot) {
  const auto is_parallel = [&](std::uint32_t other) {
    return float_planes_[slot].normal.dot(float_planes_[other].normal) >= min_cosine_;
  };
  std::vector<std::uint32_t> neighbours;
  index_.near(index_.touched_by(slot), cube_side(hypotheses_[slot].normal()), is_parallel,
              neighbours);
  return neighbours;
}

/// Merges all smaller neighbours that are one plane with the hypothesis at `slot` into it. Returns
/// true if there were any.
bool PlaneMap::absorb_neighbours(std::uint32_t slot) {
  if (!is_alive(slot)) return false;
  bool changed = false;
  for (const std::uint32_t other : parallel_neighbours(slot)) {
    if (other == slot || !is_alive(other)) continue;
    if (hypotheses_[other].area_m2() > hypotheses_[slot].area_m2()) continue;
    if (!are_one_plane(hypotheses_[slot], hypotheses_[other], gates_)) continue;
    const std::int64_t id = ids_[slot];
    merge(slot, other);
    ids_[slot] = id;  // the larger one's, even if the sliver is older
    changed = true;
  }
  return changed;
}

/// Returns the id of each ribbon's hypothesis, or kNoId. Leaves out hypotheses that `now` shares.
std::vector<std::int64_t> PlaneMap::ids_of_ribbons(const SharedVector<Hypothesis>& now) const {
  std::vector<std::int64_t> ids;
  for (std::uint32_t slot = 0; slot < hypotheses_.size(); ++slot) {
    if (hypotheses_.shares(slot, now)) continue;
    for (const Member& member : hypotheses_[slot].members()) {
      if (member.ribbon >= ids.size()) ids.resize(member.ribbon + 1, kNoId);
      ids[member.ribbon] = ids_[slot];
    }
  }
  return ids;
}

/// Adds the shares of the hypothesis at a slot, given the former ids of its ribbons.
void PlaneMap::add_shares(std::uint32_t slot, std::vector<std::int64_t>& ids,
                          std::vector<Share>& shares) {
  if (!std::is_sorted(ids.begin(), ids.end())) std::sort(ids.begin(), ids.end());
  for (auto id = ids.begin(), next = id; id != ids.end(); id = next) {
    next = std::upper_bound(id, ids.end(), *id);
    shares.push_back({static_cast<std::size_t>(next - id), *id, slot});
  }
}

/// Returns the numbers of ribbons that each hypothesis shares with former ones, given the former
/// ids of the ribbons, and the former map if hypotheses may be shared with it. See take_ids_from().
std::vector<PlaneMap::Share> PlaneMap::shares_with(
    const std::vector<std::int64_t>& ids_before, const PlaneMap* before,
    const std::vector<std::uint32_t>& index_before) const {
  std::vector<Share> shares;
  shares.reserve(hypotheses_.size());
  std::vector<std::int64_t> ids;  // former ids of the ribbons of one hypothesis
  for (std::uint32_t slot = 0; slot < hypotheses_.size(); ++slot) {
    const std::vector<Member>& members = hypotheses_[slot].members();
    if (before && hypotheses_.shares(slot, before->hypotheses_)) {  // the same ribbons
      if (!members.empty()) shares.push_back({members.size(), before->ids_[slot], slot});
      continue;
    }
    ids.clear();
    for (const Member& member : members) {
      const std::size_t ribbon = index_before.empty() ? member.ribbon : index_before[member.ribbon];
      if (ribbon >= ids_before.size() || ids_before[ribbon] == kNoId) continue;
      ids.push_back(ids_before[ribbon]);
    }
    add_shares(slot, ids, shares);
  }
  return shares;
}

/// Gives each hypothesis the id with which it shares the most, unless another shares more. Returns
/// by slot whether it got one.
std::vector<bool> PlaneMap::name_by(std::vector<Share> shares) {
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.ribbons > b.ribbons; });
  tsl::robin_set<std::int64_t> taken;
  taken.reserve(hypotheses_.size());
  std::vector<bool> named(hypotheses_.size(), false);
  for (const Share& share : shares) {
    if (named[share.slot] || !taken.insert(share.id).second) continue;
    ids_[share.slot] = share.id;
    named[share.slot] = true;
  }
  return named;
}

void PlaneMap::take_ids_from(const PlaneMap& before,
                             const std::vector<std::uint32_t>& index_before) {
  name_by(shares_with(before.ids_of_ribbons(hypotheses_), &before, index_before));
}

void PlaneMap::take_ids(const std::vector<std::int64_t>& ids_of_ribbons, std::int64_t next_id) {
  const std::vector<bool> named = name_by(shares_with(ids_of_ribbons, nullptr, {}));
  next_id_ = next_id;
  for (std::uint32_t slot = 0; slot < hypotheses_.size(); ++slot) {
    if (is_alive(slot) && !named[slot]) ids_[slot] = next_id_++;
  }
}

PlaneMap PlaneMap::restored(const State& state, std::int64_t first_id) const {
  PlaneMap map = *this;
  map.hypotheses_ = state.hypotheses;
  map.free_slots_ = state.free_slots;
  map.index_.restore(state.index);
  map.created_ = state.created;
  map.next_id_ = first_id + state.created;
  map.ids_.clear(), map.float_planes_.clear();
  for (std::uint32_t slot = 0; slot < map.hypotheses_.size(); ++slot) {
    const Hypothesis& plane = map.hypotheses_[slot];
    map.ids_.push_back(first_id + plane.id);
    map.float_planes_.push_back({plane.normal().cast<float>(), static_cast<float>(plane.d_m())});
  }
  return map;
}

std::size_t PlaneMap::State::unshared_bytes(const State& later) const {
  std::size_t bytes = VoxelIndex::unshared_bytes(index, later.index) + hypotheses.memory_bytes() +
                      free_slots.capacity() * sizeof(std::uint32_t);
  hypotheses.for_each_unshared(later.hypotheses, [&bytes](const Hypothesis& plane) {
    bytes += sizeof(Hypothesis) + plane.members().capacity() * sizeof(Member);
  });
  return bytes;
}

std::size_t PlaneMap::memory_bytes() const {
  std::size_t bytes = index_.memory_bytes() + hypotheses_.memory_bytes() +
                      ids_.capacity() * sizeof(std::int64_t) +
                      float_planes_.capacity() * sizeof(FloatPlane) +
                      free_slots_.capacity() * sizeof(std::uint32_t);
  hypotheses_.for_each_unshared({}, [&bytes](const Hypothesis& plane) {
    bytes += sizeof(Hypothesis) + plane.members().capacity() * sizeof(Member);
  });
  return bytes;
}

}  // namespace ribbon_mapper
