// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "eval/experiment/run_options.hpp"
#include "eval/metrics/map_metrics.hpp"
#include "eval/results/four_models.hpp"
#include "eval/results/trajectory_error.hpp"
#include "eval/segmentation/point_metrics.hpp"
#include "eval/semantics/label_confusion.hpp"
#include "modeler/chain/pose_precision.hpp"

namespace ribbon_mapper::eval {

/// The metrics of each of the four models.
using FourMetrics = PerModel<MapMetrics>;

/// What an estimate of the trajectory says of itself.
struct EstimateReport {
  TrajectoryError live;           ///< of the poses that lines had when they were the newest
  PosePrecision precision;        ///< as its covariances state it
  double nees = 0.0;              ///< of the final trajectory, see planar_nees()
  double noise_scale = 1.0;       ///< learnt for the odometry, as a multiple of gmapping's
  double updates_s = 0.0;         ///< computing time of all lines
  double longest_update_s = 0.0;  ///< computing time of the line that took longest
  double finish_s = 0.0;          ///< computing time of the final adjustment
  double covariances_s = 0.0;     ///< computing time of the covariances
  /// Where it was lost and found: for each decision its time, its name, and why.
  std::vector<std::string> decisions;
};

/// An estimate of the trajectory without ground truth.
struct EstimateSummary {
  TrajectoryError error;                 ///< of the final trajectory
  std::optional<EstimateReport> report;  ///< empty over ROS
};

/// Metrics and times of one run, whether in one process or over ROS.
struct Summary {
  RunOptions run;       ///< the conditions; empty strings are unknown
  std::string command;  ///< command that repeats the run

  std::size_t lines = 0;          ///< scan lines of the tour
  std::size_t dropped_lines = 0;  ///< lines that the modeler refused
  std::size_t ribbons = 0;        ///< ribbons of the model
  FourMetrics metrics;            ///< by planes
  /// By points, against the face that each beam hit; empty over ROS, where beams have no labels.
  std::optional<PerModel<PointMetrics>> points;

  /// Labels of the corrected, final planes; empty if the world does not say what its shapes are,
  /// and over ROS.
  std::optional<LabelConfusion> labels;

  std::optional<EstimateSummary> estimate;  ///< with RunOptions::closure `self`

  /// Median angle between ribbons' normals and the true ones, at corrected poses.
  std::optional<double> ribbon_angle_deg;
  /// Median distance of ribbons' centroids from their true planes, at corrected poses.
  std::optional<double> ribbon_distance_m;

  /// Position error of the last acquisition pose before the correction.
  double end_drift_m = 0.0;
  /// Orientation error of the last acquisition pose before the correction.
  double end_drift_deg = 0.0;
  double us_per_line = 0.0;       ///< median computing time per line
  double correction_ms = 0.0;     ///< time of Modeler::correct()
  double real_time_factor = 0.0;  ///< seconds of tour per second of computing
};

/// Converts a summary to JSON; docs/experiments.md describes the keys.
std::string summary_to_json(const Summary& summary, const std::string& run_id = "");

/// Converts a summary to a line of runs.jsonl: the same keys without the times, which are not
/// reproducible. `inputs` is the fingerprint from inputs_of().
std::string run_line(const Summary& summary, const std::string& inputs);

/// Converts the times of a run, with its conditions, to a line of timings.jsonl.
std::string timing_line(const Summary& summary);

/// Formats the metrics of the four models as tables for a terminal, with a line about the run.
std::string summary_table(const Summary& summary);

}  // namespace ribbon_mapper::eval
