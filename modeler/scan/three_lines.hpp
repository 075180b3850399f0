// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "modeler/geometry/moments.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

/// A scan line with the line before and the line after it: the neighbourhood of eq. 1 of the paper.
/// All three have the same number of beams and outlive this view.
struct ThreeLines {
  const ScanLine& previous;  ///< the line before, far enough away for a normal
  const ScanLine& middle;    ///< the line whose surfels and ribbons are wanted
  const ScanLine& next;      ///< the line after, far enough away for a normal

  /// Returns the moments of the returns of all three lines among beams [begin, end).
  Moments moments(std::size_t begin, std::size_t end) const {
    return previous.moments(begin, end) + middle.moments(begin, end) + next.moments(begin, end);
  }

  /// Returns true if all three lines have a return at `beam`.
  bool have_return(std::size_t beam) const {
    return previous.has_return(beam) && middle.has_return(beam) && next.has_return(beam);
  }
};

}  // namespace ribbon_mapper
