// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/observations/observations.hpp"

#include <algorithm>
#include <utility>

#include "modeler/geometry/vector_storage.hpp"
#include "modeler/observations/thinning.hpp"

namespace ribbon_mapper {

Observations::Observations(Parts parts)
    : ribbons_(std::move(parts.ribbons)),
      unassigned_(std::move(parts.unassigned)),
      trajectory_(std::move(parts.trajectory)),
      samples_(std::move(parts.samples)),
      points_(std::move(parts.points)) {}

std::uint32_t Observations::add_line(const TrackedPose& pose, const LineObservations& line) {
  std::size_t sample_count = 0;
  for (const Ribbon& ribbon : line.ribbons) sample_count += ribbon.samples.size;
  // All memory is reserved first, so that nothing is half changed if it runs out.
  trajectory_.reserve_one_more();
  reserve_one_more(unassigned_);
  reserve_more(ribbons_, line.ribbons.size());
  points_.reserve(line.unassigned.size);
  samples_.reserve(sample_count);

  const auto first = static_cast<std::uint32_t>(ribbons_.size());
  const auto index = static_cast<std::uint32_t>(trajectory_.size());
  trajectory_.add(pose);
  unassigned_.push_back(line.unassigned);
  UnassignedPoints& points = unassigned_.back();
  points.pose = index;
  points.first = points_.add(points.first, points.size);
  for (const Ribbon& source : line.ribbons) {
    ribbons_.push_back(source);
    Ribbon& ribbon = ribbons_.back();
    ribbon.pose = index;
    ribbon.samples.first = samples_.add(ribbon.samples.first, ribbon.samples.size);
  }
  return first;
}

std::uint32_t Observations::first_ribbon_of(std::size_t line) const {
  const auto first =
      std::lower_bound(ribbons_.begin(), ribbons_.end(), line,
                       [](const Ribbon& ribbon, std::size_t pose) { return ribbon.pose < pose; });
  return static_cast<std::uint32_t>(first - ribbons_.begin());
}

std::vector<std::uint32_t> Observations::thin(std::size_t count) {
  std::vector<std::uint32_t> kept = thinned(posed(), count);
  std::vector<std::uint32_t> kept_poses;
  for (const std::uint32_t index : kept) {
    const std::uint32_t pose = ribbons_[index].pose;
    if (kept_poses.empty() || kept_poses.back() != pose) kept_poses.push_back(pose);
  }
  compact_storage(kept, kept_poses);  // the last step that needs memory
  keep_indices(kept, ribbons_);
  std::uint32_t pose = 0;
  for (Ribbon& ribbon : ribbons_) {
    if (ribbon.pose != kept_poses[pose]) ++pose;
    ribbon.pose = pose;
  }
  trajectory_.keep(kept_poses);
  keep_indices(kept_poses, unassigned_);
  for (std::uint32_t i = 0; i < unassigned_.size(); ++i) unassigned_[i].pose = i;
  return kept;
}

/// Keeps only the samples of these ribbons and the points of these lines.
void Observations::compact_storage(const std::vector<std::uint32_t>& ribbons,
                                   const std::vector<std::uint32_t>& lines) {
  PackedStore<PackedSample> samples;
  PackedStore<PackedPoint> points;
  std::vector<const PackedSample*> first_samples;
  std::vector<const PackedPoint*> first_points;
  first_samples.reserve(ribbons.size()), first_points.reserve(lines.size());
  for (const std::uint32_t i : ribbons) {
    const RibbonSamples& source = ribbons_[i].samples;
    first_samples.push_back(samples.add(source.first, source.size));
  }
  for (const std::uint32_t i : lines) {
    first_points.push_back(points.add(unassigned_[i].first, unassigned_[i].size));
  }
  for (std::size_t i = 0; i < ribbons.size(); ++i)
    ribbons_[ribbons[i]].samples.first = first_samples[i];
  for (std::size_t i = 0; i < lines.size(); ++i) unassigned_[lines[i]].first = first_points[i];
  samples_ = std::move(samples);
  points_ = std::move(points);
}

std::size_t Observations::memory_bytes() const {
  return ribbons_.capacity() * sizeof(Ribbon) + unassigned_.capacity() * sizeof(UnassignedPoints) +
         samples_.memory_bytes() + points_.memory_bytes() + trajectory_.memory_bytes();
}

}  // namespace ribbon_mapper
