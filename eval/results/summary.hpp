// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "eval/experiment/run_options.hpp"
#include "eval/metrics/map_metrics.hpp"
#include "eval/metrics/point_metrics.hpp"
#include "eval/results/four_models.hpp"

namespace ribbon_mapper::eval {

using FourMetrics = PerModel<MapMetrics>;

/// What one tour says, whether it ran in one process or over ROS.
struct Summary {
  RunOptions run;       ///< empty texts: not known
  std::string command;  ///< that makes it again

  std::size_t lines = 0;
  std::size_t dropped_lines = 0;  ///< of these, lines that the modeler could not use
  std::size_t ribbons = 0;
  FourMetrics cells;
  /// Against the face that each beam hit; over ROS beams have no labels.
  std::optional<PerModel<PointMetrics>> points;

  /// Medians over the ribbons, where the corrected trajectory places them.
  std::optional<double> ribbon_angle_deg, ribbon_distance_m;

  double end_drift_m = 0.0;  ///< last acquisition pose before the correction, from the truth
  double end_drift_deg = 0.0;
  double us_per_line = 0.0;       ///< median time that the modeler took for a line
  double correction_ms = 0.0;     ///< evaluating the whole model again
  double real_time_factor = 0.0;  ///< seconds of tour per second of computing
};

/// All of it as JSON, keys as in docs/experiments.md.
std::string summary_to_json(const Summary& summary);

/// The same in one line, without the times, which differ from run to run: a line of runs.jsonl.
/// `inputs` as inputs_of() gives them.
std::string run_line(const Summary& summary, const std::string& inputs);

/// The times, with what is needed to tell the run, in one line.
std::string timing_line(const Summary& summary);

/// The four cells as tables for a terminal, and a line about the run.
std::string summary_table(const Summary& summary);

}  // namespace ribbon_mapper::eval
