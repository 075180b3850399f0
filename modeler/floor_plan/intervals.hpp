// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ribbon_mapper {

/// A piece of a line [m].
struct Interval {
  double begin = 0.0;  ///< lower end
  double end = 0.0;    ///< upper end

  /// Returns the length.
  double length() const { return end - begin; }
  /// Returns the middle.
  double middle() const { return 0.5 * (begin + end); }
};

/// Pieces of a line that do not touch each other, in ascending order.
using Intervals = std::vector<Interval>;

/// Returns the pieces that are in at least one interval. Pieces that are up to `gap` apart are one.
Intervals united(Intervals intervals, double gap = 0.0);

/// Returns the pieces that are in both.
Intervals intersection(const Intervals& a, const Intervals& b);

/// Returns the pieces of `a` that are not in `b`.
Intervals difference(const Intervals& a, const Interval& b);

/// Returns the pieces of `a` that are not in `b`.
Intervals difference(Intervals a, const Intervals& b);

}  // namespace ribbon_mapper
