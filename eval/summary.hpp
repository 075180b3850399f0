// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "eval/map_metrics.hpp"

namespace ribbon_mapper::eval {

/// The four cells of every table: {noisy, corrected trajectory} x {as built, merged and filtered}.
struct FourCells {
  MapMetrics noisy_raw;         ///< as built on the way, at the end of the tour
  MapMetrics noisy_merged;      ///< what mere merging would have done
  MapMetrics corrected_raw;     ///< what the correction did
  MapMetrics corrected_merged;  ///< the result
};

/// What one tour says, whether it ran in one process or over ROS.
struct Summary {
  std::string command;  ///< that makes it again
  std::string world;
  std::string route;
  std::uint64_t seed = 0;
  double drift = 0.0;  ///< scale of the localisation noise, 1: the PR2's parameters

  std::size_t lines = 0;
  std::size_t dropped_lines = 0;  ///< of these, lines that the modeler could not use
  std::size_t ribbons = 0;
  FourCells cells;

  double end_drift_m = 0.0;  ///< last acquisition pose before the correction, from the truth
  double end_drift_deg = 0.0;
  double us_per_line = 0.0;       ///< median time that the modeler took for a line
  double correction_ms = 0.0;     ///< evaluating the whole model again
  double real_time_factor = 0.0;  ///< seconds of tour per second of computing
};

/// All of it as JSON, keys as in the README.
std::string summary_to_json(const Summary& summary);

/// The four cells as a table for a terminal, and a line about the run.
std::string summary_table(const Summary& summary);

}  // namespace ribbon_mapper::eval
