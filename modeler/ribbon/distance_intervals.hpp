// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ribbon_mapper {

/// Groups numbers into intervals separated by gaps (single linkage). Numbers need not be sorted:
/// there are few intervals, and successive numbers mostly fall into the same one.
class DistanceIntervals {
 public:
  /// Creates an empty set of intervals that are separated by more than `gap`.
  explicit DistanceIntervals(double gap) : gap_(gap) {}

  /// Removes all intervals.
  void clear() { intervals_.clear(), latest_ = 0; }

  /// Adds a number, which extends, joins or creates an interval.
  void add(double number) {
    if (latest_ < intervals_.size() && intervals_[latest_].holds(number)) return;
    latest_ = first_with_end_from(number - gap_);
    const auto place = intervals_.begin() + static_cast<std::ptrdiff_t>(latest_);
    if (place == intervals_.end() || place->min - number > gap_) {
      intervals_.insert(place, {number, number});
      return;
    }
    place->min = std::min(place->min, number);
    place->max = std::max(place->max, number);
    const auto after = place + 1;
    if (after == intervals_.end() || after->min - place->max > gap_) return;
    place->max = after->max;
    intervals_.erase(after);
  }

  /// Returns the number of intervals.
  std::size_t size() const { return intervals_.size(); }

  /// Returns the index of the interval that holds a number, once all numbers have been added.
  std::size_t of(double number) const { return first_with_end_from(number); }

 private:
  struct Interval {
    double min, max;
    bool holds(double number) const { return min <= number && number <= max; }
  };

  std::size_t first_with_end_from(double number) const {
    std::size_t i = 0;
    while (i < intervals_.size() && intervals_[i].max < number) ++i;
    return i;
  }

  double gap_;
  std::vector<Interval> intervals_;  // ascending, more than the gap apart
  std::size_t latest_ = 0;
};

}  // namespace ribbon_mapper
