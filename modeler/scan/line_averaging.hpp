// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper {

/// Lines so close to each other that each alone would add noise only, taken together as one: each
/// beam at the mean of its ranges (where most of its returns agree), the laser at the mean of its
/// poses. The mean of n lines has a noise smaller by the root of n, so it needs a base line that
/// much shorter.
class LineAverager {
 public:
  /// Fewer are where a tilt turns round, not a laser whose lines are too dense.
  static constexpr std::size_t kMinLines = 4;

  explicit LineAverager(const ScanConfig& config) : config_(config) {}

  /// A line of other beams than those before it starts the pool afresh, as does a full pool.
  void add(const LaserBeams& beams, const LinePoses& poses);
  void clear() { lines_ = 0; }

  std::size_t lines() const { return lines_; }
  Time last_stamp() const { return last_stamp_; }  ///< of the last line added, its middle

  // Valid while there are lines.
  const LaserBeams& beams();
  const LinePoses& poses() const { return poses_; }

 private:
  ScanConfig config_;
  std::size_t lines_ = 0;
  Time last_stamp_{0};
  LaserBeams beams_;  // of the first line, stamped at the mean
  LinePoses poses_;
  std::vector<float> sums_m_;
  std::vector<std::uint16_t> returns_, agreeing_;  // of each beam
};

}  // namespace ribbon_mapper
