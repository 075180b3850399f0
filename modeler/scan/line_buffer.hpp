// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

/// The circular buffer of three successive lines of section 4.1. A line enters only when it has
/// moved far enough from the line before it for a base line above the noise.
class LineBuffer {
 public:
  /// Line to be filled with place_beams() before push().
  ScanLine& incoming() { return lines_[(newest_ + 1) % 4]; }

  /// Takes the incoming line in. A line of another beam count starts the buffer afresh.
  void push();
  void clear();

  bool is_full() const { return count_ >= 3; }
  const ScanLine* newest_line() const { return count_ > 0 ? &lines_[newest_] : nullptr; }

  // Valid while is_full().
  const ScanLine& previous() const { return lines_[(newest_ + 2) % 4]; }
  const ScanLine& middle() const { return lines_[(newest_ + 3) % 4]; }
  const ScanLine& next() const { return lines_[newest_]; }

 private:
  std::array<ScanLine, 4> lines_;
  std::size_t newest_ = 3;
  std::size_t count_ = 0;
};

/// Median over the beams of how far `line`'s beams lie from those of `before`, across the lines and
/// at the ranges of `line` [m]; a shift along the lines does not count. 0 if there are no returns, infinite if the lines have different beam counts.
double base_line_m(const ScanLine& before, const ScanLine& line);

}  // namespace ribbon_mapper
