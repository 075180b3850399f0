// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ribbon_mapper {

/// Numbers cut where they leave gaps (single linkage), without sorting them: there are few
/// intervals, and numbers come in runs that lie in the same one.
class DistanceIntervals {
 public:
  explicit DistanceIntervals(double gap) : gap_(gap) {}

  void clear() { intervals_.clear(), latest_ = 0; }

  void add(double number) {
    if (latest_ < intervals_.size() && intervals_[latest_].holds(number)) return;
    latest_ = first_with_end_from(number - gap_);
    const auto place = intervals_.begin() + static_cast<std::ptrdiff_t>(latest_);
    if (place == intervals_.end() || place->least - number > gap_) {
      intervals_.insert(place, {number, number});
      return;
    }
    place->least = std::min(place->least, number);
    place->most = std::max(place->most, number);
    const auto after = place + 1;
    if (after == intervals_.end() || after->least - place->most > gap_) return;
    place->most = after->most;
    intervals_.erase(after);
  }

  std::size_t size() const { return intervals_.size(); }

  /// Index of the interval of a number that was added, when all are.
  std::size_t of(double number) const { return first_with_end_from(number); }

 private:
  struct Interval {
    double least, most;
    bool holds(double number) const { return least <= number && number <= most; }
  };

  std::size_t first_with_end_from(double number) const {
    std::size_t i = 0;
    while (i < intervals_.size() && intervals_[i].most < number) ++i;
    return i;
  }

  double gap_;
  std::vector<Interval> intervals_;  // ascending, more than the gap apart
  std::size_t latest_ = 0;
};

}  // namespace ribbon_mapper
