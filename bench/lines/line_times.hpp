// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench/recording/recording.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {

/// CPU time of each line of a tour [s].
struct LineTimes {
  std::vector<double> lines;        ///< all that were given to the modeler
  std::vector<LineResult> results;  ///< what became of each
  double total_s() const;
  std::vector<double> modelled() const;  ///< of those that entered the model
};

/// Feeds a whole tour, with the poses that the robot believed.
LineTimes feed(const Recording& tour, Modeler& modeler);

/// Several times; of each line the median over the repetitions, so that what interrupts one of them
/// does not count.
LineTimes median_line_times(const Recording& tour, const ModelerConfig& config, int repetitions);

}  // namespace ribbon_mapper::bench
