// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

/// The circular buffer of section 4.1, from which each line gets a line before and one after it for
/// its normals. The paper takes the ones next to it; where lines lie closer together than the noise
/// allows, it is the nearest ones that are far enough away.
class LineBuffer {
 public:
  explicit LineBuffer(double base_line_m) : base_line_m_(base_line_m) {}

  /// Line to be filled with place_beams() before push().
  ScanLine& incoming() { return lines_[(newest_ + 1) % kSlots]; }

  /// Takes the incoming line in. A line of another beam count starts the buffer afresh.
  void push();
  void clear() { count_ = done_ = 0; }

  const ScanLine* newest_line() const { return count_ > 0 ? &lines_[newest_] : nullptr; }

  /// Goes on to the next line that has one far enough before and one far enough after it; false if
  /// there is none yet.
  bool advance();

  // Valid after advance() was true, until push().
  const ScanLine& previous() const { return lines_[previous_]; }
  const ScanLine& middle() const { return lines_[middle_]; }
  const ScanLine& next() const { return lines_[next_]; }

 private:
  static constexpr std::size_t kSlots = 25;  // one of them for the incoming line

  std::size_t slot(std::size_t age) const { return (newest_ + kSlots - age) % kSlots; }
  bool are_apart(const ScanLine& before, const ScanLine& line) const;

  double base_line_m_;
  std::array<ScanLine, kSlots> lines_;
  std::size_t newest_ = 0;
  std::size_t count_ = 0;  ///< lines in the buffer
  std::size_t done_ = 0;   ///< of these, the oldest ones that have been the middle or cannot be
  std::size_t previous_ = 0, middle_ = 0, next_ = 0;  // slots
};

/// Median over the beams of how far `line`'s beams lie from those of `before`, across the lines and
/// at the ranges of `line` [m]; a shift along the lines does not count. 0 if there are no returns,
/// infinite if the lines have different beam counts.
double base_line_m(const ScanLine& before, const ScanLine& line);

}  // namespace ribbon_mapper
