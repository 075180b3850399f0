// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

/// Maps the beams of a line to those of another one by their bearing, because some lasers take
/// another number of beams in each turn. Lines with the same bearings are mapped index by index.
class BeamMatch {
 public:
  /// Creates the map from the beams of `from` to those of `to`, which must outlive it. Both turn
  /// the same way round.
  BeamMatch(const ScanLine& from, const ScanLine& to)
      : to_(&to),
        same_(from.size() == to.size() && from.first_angle_rad == to.first_angle_rad &&
              from.angle_increment_rad == to.angle_increment_rad),
        scale_(from.angle_increment_rad / to.angle_increment_rad),
        shift_((from.first_angle_rad - to.first_angle_rad) / to.angle_increment_rad) {}

  /// Returns true if both lines have the same bearings.
  bool is_by_index() const { return same_; }

  /// Returns the index of the beam that points nearest to the bearing of `beam`. It lies outside of
  /// the other line where that has no beam.
  std::int64_t nearest(std::size_t beam) const {
    if (same_) return static_cast<std::int64_t>(beam);
    return static_cast<std::int64_t>(std::floor(position(beam) + 0.5));
  }
  /// Returns true if the other line has a return at the bearing of `beam`.
  bool has_return(std::size_t beam) const {
    if (same_) return to_->has_return(beam);
    const std::int64_t at = nearest(beam);
    return at >= 0 && at < size() && to_->has_return(static_cast<std::size_t>(at));
  }
  /// Returns the first beam at the bearings of the other line's segment around `beam`, at which it
  /// must have a return. This may lie outside of the line.
  std::int64_t first_of_segment(std::size_t beam) const {
    return first_at(to_->first_of_segment[static_cast<std::size_t>(nearest(beam))]);
  }
  /// Returns one past the last beam at the bearings of that segment.
  std::int64_t end_of_segment(std::size_t beam) const {
    return first_at(to_->end_of_segment[static_cast<std::size_t>(nearest(beam))]);
  }
  /// Returns the moments of the other line's returns at the bearings of beams [begin, end).
  Moments moments(std::size_t begin, std::size_t end) const {
    return same_ ? to_->moments(begin, end) : matched_moments(begin, end);
  }
  /// Returns the direction of the other line at the bearing of `beam`. Interpolates between beams.
  Eigen::Vector3d direction(std::size_t beam) const;

 private:
  std::int64_t size() const { return static_cast<std::int64_t>(to_->size()); }
  /// Returns the first beam whose nearest one is not before `other`.
  std::int64_t first_at(std::uint32_t other) const {
    if (same_) return other;
    return static_cast<std::int64_t>(std::ceil((other - 0.5 - shift_) / scale_));
  }
  double position(std::size_t beam) const { return shift_ + scale_ * static_cast<double>(beam); }
  Moments matched_moments(std::size_t begin, std::size_t end) const;

  const ScanLine* to_;
  bool same_;
  double scale_, shift_;  // index in `to` = shift + scale * index in `from`
};

}  // namespace ribbon_mapper
