// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/checkpoints.hpp"

#include <algorithm>

namespace ribbon_mapper {

/// Returns the largest gap before a checkpoint, for which there must be no other one between.
std::uint32_t Checkpoints::gap(std::uint32_t ribbons, std::uint32_t all) const {
  return std::max({min_ribbons_, all / 256, (all - ribbons) / 2});
}

void Checkpoints::offer(const PlaneMap& map, std::uint32_t ribbons, std::uint32_t all) {
  if (min_ribbons_ == 0) return;
  const std::uint32_t last = checkpoints_.empty() ? 0 : checkpoints_.back()->ribbons;
  if (ribbons - last < gap(ribbons, all)) return;
  std::vector<std::shared_ptr<const Checkpoint>> kept;
  kept.reserve(checkpoints_.size() + 1);
  for (std::size_t i = 0; i < checkpoints_.size(); ++i) {
    const bool is_last = i + 1 == checkpoints_.size();
    const std::uint32_t before = kept.empty() ? 0 : kept.back()->ribbons;
    const std::uint32_t after = is_last ? ribbons : checkpoints_[i + 1]->ribbons;
    if (after - before > gap(after, all)) kept.push_back(checkpoints_[i]);
  }
  kept.push_back(std::make_shared<Checkpoint>(Checkpoint{ribbons, map.state()}));
  checkpoints_ = std::move(kept);
}

const Checkpoints::Checkpoint* Checkpoints::last_until(std::uint32_t ribbons) const {
  const auto after =
      std::find_if(checkpoints_.begin(), checkpoints_.end(),
                   [ribbons](const auto& other) { return other->ribbons > ribbons; });
  return after == checkpoints_.begin() ? nullptr : std::prev(after)->get();
}

Checkpoints Checkpoints::until(std::uint32_t ribbons) const {
  Checkpoints before = *this;
  while (!before.checkpoints_.empty() && before.checkpoints_.back()->ribbons > ribbons) {
    before.checkpoints_.pop_back();
  }
  return before;
}

std::size_t Checkpoints::memory_bytes(const PlaneMap& now) const {
  const PlaneMap::State last = now.state();
  std::size_t bytes = checkpoints_.size() * sizeof(Checkpoint);
  for (std::size_t i = 0; i < checkpoints_.size(); ++i) {
    const bool is_last = i + 1 == checkpoints_.size();
    bytes += checkpoints_[i]->state.unshared_bytes(is_last ? last : checkpoints_[i + 1]->state);
  }
  return bytes;
}

}  // namespace ribbon_mapper
