// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "modeler/scan/three_lines.hpp"

namespace ribbon_mapper {

/// The circular buffer of section 4.1 of the paper: pairs each line with one before and one after
/// it, so that normals can be estimated.
///
/// The paper pairs a line with its direct neighbours. Where lines lie closer together than the
/// noise allows, the buffer takes the nearest ones that are far enough away.
class LineBuffer {
 public:
  /// Creates an empty buffer. Paired lines lie at least `base_line_m` apart.
  explicit LineBuffer(double base_line_m = 0.0) : base_line_m_(base_line_m) {}

  /// Returns the line to be filled by place_beams() before push().
  ScanLine& incoming() { return lines_[(newest_ + 1) % kSlots]; }

  /// Adds the incoming line. A line that turns the other way round clears the buffer first.
  void push();

  /// Removes all lines.
  void clear() { count_ = done_ = 0; }

  /// Returns the line that was pushed last, or null if there is none.
  const ScanLine* newest_line() const { return count_ > 0 ? &lines_[newest_] : nullptr; }

  /// Returns the number of lines.
  std::size_t size() const { return count_; }
  /// Returns a line by the order in which they were pushed.
  const ScanLine& line(std::size_t index) const { return lines_[slot(count_ - 1 - index)]; }
  /// Returns the number of the first lines that will not be a middle line any more.
  std::size_t done() const { return done_; }
  /// Sets done(), to at most size().
  void set_done(std::size_t lines) { done_ = std::min(lines, count_); }

  /// Returns the next middle line with its neighbours, or nothing if it has to wait for later
  /// lines. The lines stay valid until the next push().
  std::optional<ThreeLines> next_three_lines();

 private:
  static constexpr std::size_t kSlots = 25;  // one of them for the incoming line

  std::size_t slot(std::size_t age) const { return (newest_ + kSlots - age) % kSlots; }
  bool are_apart(const ScanLine& before, const ScanLine& line) const;

  double base_line_m_;
  std::array<ScanLine, kSlots> lines_;
  std::size_t newest_ = 0;
  std::size_t count_ = 0;  // lines in the buffer
  std::size_t done_ = 0;   // the oldest of these: they were the middle line or cannot be
};

/// Returns the distance between two lines' beams, at the ranges of `line` and across the lines [m].
///
/// The distance is the median over the beams; a shift along the lines does not count. Beams are
/// matched by bearing. It is 0 if `line` has no returns at bearings that both lines have, and
/// infinite if there is no such bearing, or if the lines turn opposite ways.
double base_line_m(const ScanLine& before, const ScanLine& line);

}  // namespace ribbon_mapper
