// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
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
  /// Largest number of lines in an average. More occur only where the tilt stands still.
  static constexpr std::size_t kMaxLines = 16;

  /// The sums over the lines of an average.
  struct Sums {
    std::size_t lines = 0;                ///< number of lines
    Time last_stamp{0};                   ///< of the middle of the line that was added last
    LaserBeams beams;                     ///< those of the first line, with the mean stamp
    LinePoses poses;                      ///< mean poses
    std::vector<float> sums_m;            ///< of the ranges that agree, by beam
    std::vector<std::uint16_t> returns;   ///< number of returns, by beam
    std::vector<std::uint16_t> agreeing;  ///< number of returns that agree, by beam
  };

  /// Creates an averager without lines.
  explicit LineAverager(const ScanConfig& config) : LineAverager(config, Sums()) {}
  /// Goes on from sums().
  LineAverager(const ScanConfig& config, Sums sums) : config_(config), sums_(std::move(sums)) {}

  /// Returns the sums over the lines.
  const Sums& sums() const { return sums_; }

  /// Adds a line. Beams of another bearing than the first line's are interpolated. A line with
  /// entirely other beams starts a new average, and so does a line that exceeds the largest number
  /// of averaged lines.
  void add(const LaserBeams& beams, const LinePoses& poses);

  /// Removes all lines.
  void clear() { sums_.lines = 0; }

  /// Returns the number of lines in the average.
  std::size_t lines() const { return sums_.lines; }

  /// Returns the stamp of the middle of the line that was added last.
  Time last_stamp() const { return sums_.last_stamp; }

  /// Computes the mean of the lines: each beam at the mean of its ranges, or without a return where
  /// most of its returns disagree. Needs at least one line; valid until the next call of add().
  const LaserBeams& average_beams();

  /// Returns the mean of the lines' poses. Needs at least one line.
  const LinePoses& mean_poses() const { return sums_.poses; }

 private:
  void start(const LaserBeams& beams, const LinePoses& poses);
  void approach(const LaserBeams& beams, const LinePoses& poses);
  void add_ranges(const LaserBeams& beams);

  ScanConfig config_;
  Sums sums_;
};

}  // namespace ribbon_mapper
