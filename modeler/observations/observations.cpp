// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/observations/observations.hpp"

#include <utility>

#include "modeler/geometry/vector_storage.hpp"
#include "modeler/observations/thinning.hpp"

namespace ribbon_mapper {

std::uint32_t Observations::add_line(const TrackedPose& pose, const LineObservations& line) {
  const auto first = static_cast<std::uint32_t>(ribbons_.size());
  const auto index = static_cast<std::uint32_t>(trajectory_.size());
  trajectory_.add(pose);
  reserve_one_more(unassigned_);
  unassigned_.push_back(line.unassigned);
  UnassignedPoints& points = unassigned_.back();
  points.pose = index;
  points.first = points_.add(points.first, points.size);
  for (const Ribbon& source : line.ribbons) {
    reserve_one_more(ribbons_);
    ribbons_.push_back(source);
    Ribbon& ribbon = ribbons_.back();
    ribbon.pose = index;
    ribbon.samples.first = samples_.add(ribbon.samples.first, ribbon.samples.size);
  }
  return first;
}

std::vector<std::uint32_t> Observations::thin(std::size_t count) {
  std::vector<std::uint32_t> kept = thinned(posed(), count);
  keep_indices(kept, ribbons_);
  std::vector<std::uint32_t> kept_poses;
  for (Ribbon& ribbon : ribbons_) {
    if (kept_poses.empty() || kept_poses.back() != ribbon.pose) kept_poses.push_back(ribbon.pose);
    ribbon.pose = static_cast<std::uint32_t>(kept_poses.size() - 1);
  }
  trajectory_.keep(kept_poses);
  keep_indices(kept_poses, unassigned_);
  for (std::uint32_t i = 0; i < unassigned_.size(); ++i) unassigned_[i].pose = i;
  compact_storage();
  return kept;
}

/// Releases the memory of samples and points that are no longer in use.
void Observations::compact_storage() {
  PackedStore<PackedSample> samples;
  PackedStore<PackedPoint> points;
  for (Ribbon& ribbon : ribbons_) {
    ribbon.samples.first = samples.add(ribbon.samples.first, ribbon.samples.size);
  }
  for (UnassignedPoints& line : unassigned_) line.first = points.add(line.first, line.size);
  samples_ = std::move(samples);
  points_ = std::move(points);
}

std::size_t Observations::memory_bytes() const {
  return ribbons_.capacity() * sizeof(Ribbon) + unassigned_.capacity() * sizeof(UnassignedPoints) +
         samples_.memory_bytes() + points_.memory_bytes() + trajectory_.memory_bytes();
}

}  // namespace ribbon_mapper
