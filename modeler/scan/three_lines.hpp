// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "modeler/geometry/moments.hpp"
#include "modeler/scan/beam_match.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

/// A scan line with the line before and the line after it: the neighbourhood of eq. 1 of the paper.
/// All three outlive this view. Beams are those of the middle line; the two others are matched to
/// them by bearing.
struct ThreeLines {
  /// Creates a view of three lines.
  ThreeLines(const ScanLine& previous_, const ScanLine& middle_, const ScanLine& next_)
      : previous(previous_),
        middle(middle_),
        next(next_),
        to_previous(middle_, previous_),
        to_next(middle_, next_),
        by_index_(to_previous.is_by_index() && to_next.is_by_index()) {}

  const ScanLine& previous;  ///< the line before, far enough away for a normal
  const ScanLine& middle;    ///< the line whose surfels and ribbons are wanted
  const ScanLine& next;      ///< the line after, far enough away for a normal
  BeamMatch to_previous;     ///< from the beams of the middle line to those of the previous one
  BeamMatch to_next;         ///< from the beams of the middle line to those of the next one

  /// Returns true if all three lines have the same bearings.
  bool are_matched_by_index() const { return by_index_; }

  /// Returns the moments of the returns of all three lines among beams [begin, end).
  Moments moments(std::size_t begin, std::size_t end) const {
    return to_previous.moments(begin, end) + middle.moments(begin, end) +
           to_next.moments(begin, end);
  }

  /// Returns true if all three lines have a return at `beam`.
  bool have_return(std::size_t beam) const {
    if (!middle.has_return(beam)) return false;
    if (by_index_) return previous.has_return(beam) && next.has_return(beam);
    return to_previous.has_return(beam) && to_next.has_return(beam);
  }

 private:
  bool by_index_;
};

}  // namespace ribbon_mapper
