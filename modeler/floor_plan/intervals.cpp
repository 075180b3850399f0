// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/intervals.hpp"

#include <algorithm>

namespace ribbon_mapper {

Intervals united(Intervals intervals, double gap) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.begin < b.begin; });
  Intervals result;
  for (const Interval& interval : intervals) {
    if (result.empty() || interval.begin > result.back().end + gap) {
      result.push_back(interval);
    } else {
      result.back().end = std::max(result.back().end, interval.end);
    }
  }
  return result;
}

Intervals intersection(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (const Interval& one : a) {
    for (const Interval& other : b) {
      const Interval both{std::max(one.begin, other.begin), std::min(one.end, other.end)};
      if (both.begin < both.end) result.push_back(both);
    }
  }
  return result;
}

Intervals difference(const Intervals& a, const Interval& b) {
  Intervals result;
  for (const Interval& interval : a) {
    const Interval before{interval.begin, std::min(interval.end, b.begin)};
    const Interval after{std::max(interval.begin, b.end), interval.end};
    if (before.begin < before.end) result.push_back(before);
    if (after.begin < after.end) result.push_back(after);
  }
  return result;
}

Intervals difference(Intervals a, const Intervals& b) {
  for (const Interval& interval : b) a = difference(a, interval);
  return a;
}

}  // namespace ribbon_mapper
