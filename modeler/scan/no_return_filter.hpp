// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper {

/// A range by which a driver says that there was no return.
struct NoReturnRange {
  float range_m = 0.0F;   ///< the range, to the bit
  std::size_t beams = 0;  ///< beams that had it
  double share = 0.0;     ///< of all beams so far
};

/// Finds the ranges by which a driver reports "no return" as if it were a distance, and removes
/// them: they would make surfaces on a sphere.
///
/// The ranges of a surface spread about their nearest one. A plane seen without noise at a
/// resolution q has sqrt(w / q) - 1 times as many ranges within w beyond its nearest range as at
/// it: 2.2 times for 10 cm and 10 mm, and more for noise or a finer resolution. A range is no
/// distance if neighbouring beams have it to the bit in several lines, and less than half as many
/// beams lie within 10 cm of it. It must also lie beyond nearly all other ranges, or belong to 1 %
/// of all beams: a thin object before a laser of coarse resolution does not. At range_max a single
/// line suffices.
class NoReturnFilter {
 public:
  /// What is known about a range that neighbouring beams of a line had to the bit.
  struct Candidate {
    float range_m = 0.0F;       ///< the range
    std::size_t lines = 0;      ///< lines with such neighbours
    std::size_t equal = 0;      ///< beams with this range
    std::size_t near = 0;       ///< beams within 10 cm of it, but not equal
    std::size_t beyond = 0;     ///< returns further away
    std::size_t removed = 0;    ///< beams from which it was removed
    bool is_no_return = false;  ///< what was decided
  };
  /// What lines have shown so far.
  struct Evidence {
    std::vector<Candidate> candidates;  ///< few; the least frequent one makes room for another
    std::size_t beams = 0;              ///< beams seen
  };

  /// Creates a filter that has seen no line.
  explicit NoReturnFilter(const ScanConfig& config) : NoReturnFilter(config, Evidence()) {}
  /// Goes on from evidence().
  NoReturnFilter(const ScanConfig& config, Evidence evidence)
      : config_(config), evidence_(std::move(evidence)) {}

  /// Takes note of a line and returns it: `beams` itself, or a copy in which ranges that stand for
  /// no return are infinite. Valid until the next call.
  const LaserBeams& filter(const LaserBeams& beams);

  /// Returns what lines have shown so far.
  const Evidence& evidence() const { return evidence_; }

  /// Returns the most frequent range that stands for no return; nothing if none was found.
  std::optional<NoReturnRange> found() const;

 private:
  std::optional<float> repeated_range(const LaserBeams& beams) const;
  void weigh(float range_m, const LaserBeams& beams);
  Candidate& candidate(float range_m);
  void remove(Candidate& no_return, const LaserBeams& beams);

  ScanConfig config_;
  Evidence evidence_;
  LaserBeams filtered_;
};

}  // namespace ribbon_mapper
