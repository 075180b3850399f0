// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper {

/// Averages scan lines that lie too close together for a normal, beam by beam.
///
/// The mean of n lines has a noise that is smaller by the square root of n, so a base line shorter
/// by the same factor suffices.
class LineAverager {
 public:
  /// Smallest number of lines worth averaging. Fewer occur where a tilt reverses.
  static constexpr std::size_t kMinLines = 4;

  /// Creates an averager without lines.
  explicit LineAverager(const ScanConfig& config) : config_(config) {}

  /// Adds a line. Beams of another bearing than the first line's are interpolated. A line with
  /// entirely other beams starts a new average, and so does a line that exceeds the largest number
  /// of averaged lines.
  void add(const LaserBeams& beams, const LinePoses& poses);

  /// Removes all lines.
  void clear() { lines_ = 0; }

  /// Returns the number of lines in the average.
  std::size_t lines() const { return lines_; }

  /// Returns the stamp of the middle of the line that was added last.
  Time last_stamp() const { return last_stamp_; }

  /// Computes the mean of the lines: each beam at the mean of its ranges, or without a return where
  /// most of its returns disagree. Needs at least one line; valid until the next call of add().
  const LaserBeams& average_beams();

  /// Returns the mean of the lines' poses. Needs at least one line.
  const LinePoses& mean_poses() const { return poses_; }

 private:
  void start(const LaserBeams& beams, const LinePoses& poses);
  void approach(const LaserBeams& beams, const LinePoses& poses);
  void add_ranges(const LaserBeams& beams);

  ScanConfig config_;
  std::size_t lines_ = 0;
  Time last_stamp_{0};
  LaserBeams beams_;  // the first line's, with the mean stamp
  LinePoses poses_;
  std::vector<float> sums_m_;                      // per beam
  std::vector<std::uint16_t> returns_, agreeing_;  // per beam
};

}  // namespace ribbon_mapper
