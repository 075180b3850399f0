// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench/recording/recording.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {

/// CPU time of each line of a tour [s].
struct LineTimes {
  std::vector<double> lines;        ///< time of each line
  std::vector<LineResult> results;  ///< result of each line

  /// Returns the sum over all lines.
  double total_s() const;

  /// Returns the times of those lines that entered the model.
  std::vector<double> modelled() const;
};

/// Feeds a whole tour with noisy poses to the modeler and returns the times.
LineTimes feed(const Recording& tour, Modeler& modeler);

/// Feeds a tour several times to new modelers. Returns the median time of each line over the
/// repetitions, which excludes interruptions.
LineTimes median_line_times(const Recording& tour, const ModelerConfig& config, int repetitions);

}  // namespace ribbon_mapper::bench
