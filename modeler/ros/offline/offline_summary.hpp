// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "modeler/chain/pose_precision.hpp"
#include "modeler/report/changed_keys.hpp"
#include "modeler/ros/offline/base_scans.hpp"

namespace ribbon_mapper {

/// What an estimate of the trajectory says of itself.
struct EstimateFigures {
  PosePrecision precision;   ///< as its covariances state it
  double noise_scale = 1.0;  ///< learnt for the odometry, as a multiple of gmapping's
  std::optional<BaseScanFigures> base_scans;  ///< of the level laser, if it was used
  /// Where it was lost and found: for each decision its time, its name, and why.
  std::vector<std::string> decisions;
};

/// Summary of modelling a recording.
struct OfflineSummary {
  std::vector<std::string> bags;       ///< file names
  std::string config;                  ///< preset
  std::vector<ChangedKey> parameters;  ///< what it changes, see changed_keys()
  std::string scan_topic;              ///< of the laser
  std::optional<double> moved_m;       ///< largest way that a pose was moved by the correction
  std::string trajectory;              ///< where the poses of the final model are from

  std::optional<EstimateFigures> estimate;  ///< with the trajectory `self`

  std::vector<std::string> notes;  ///< what was chosen and what is doubtful, a sentence each

  std::size_t lines = 0;                             ///< scans received
  std::map<std::string, std::size_t> dropped_lines;  ///< by reason
  std::string newest_drop;                           ///< see LineLog::newest_drop()
  std::map<std::string, std::size_t> handled_lines;  ///< by outcome, see LineResult
  std::size_t lost_lines = 0;               ///< before they were recorded, see LineLog::lost()
  std::size_t repeated_transforms = 0;      ///< left out: stamped as one before
  std::size_t refused_transforms = 0;       ///< left out: unusable
  std::size_t ribbons = 0;                  ///< in the model
  std::size_t planes_before = 0;            ///< as built, with recorded poses
  std::size_t planes = 0;                   ///< in the final model
  std::size_t duplicates = 0;               ///< in the final model, see DuplicateRule
  std::size_t points = 0;                   ///< on the planes
  std::optional<double> residual_m_median;  ///< of these points, see median_residual_m()

  double recording_s = 0.0;      ///< from the first line to the last
  double wall_s = 0.0;           ///< elapsed time, reading included
  double cpu_s = 0.0;            ///< user and system time
  double peak_memory_mib = 0.0;  ///< resident
};

/// Returns the number of lines dropped for any reason.
std::size_t dropped_total(const OfflineSummary& summary);

/// Returns the seconds of recording per second of elapsed time, reading included.
double real_time_factor(const OfflineSummary& summary);

/// Returns the summary as a JSON object with the id of the run.
std::string summary_to_json(const OfflineSummary& summary, const std::string& run_id);

/// Returns a few lines for a terminal.
std::string summary_text(const OfflineSummary& summary);

}  // namespace ribbon_mapper
