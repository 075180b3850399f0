// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace ribbon_mapper {

/// Successive beams [begin, end) of a scan line.
struct BeamRange {
  std::size_t begin = 0;  ///< index of the first beam
  std::size_t end = 0;    ///< one past the index of the last beam

  /// Returns the number of beams.
  std::size_t size() const { return end - begin; }
  /// Returns true if there is no beam.
  bool empty() const { return begin == end; }
  /// Returns the index of the beam in the middle.
  std::size_t middle() const { return (begin + end) / 2; }
};

}  // namespace ribbon_mapper
