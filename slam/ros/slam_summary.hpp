// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "slam/level/level_slam.hpp"

namespace ribbon_mapper::slam {

/// Summary of a run of `offline_slam`.
struct SlamSummary {
  std::vector<std::string> bags;   ///< file names
  std::string scan_topic;          ///< of the laser
  std::string odom_frame;          ///< frame of odometry
  std::string base_frame;          ///< frame whose trajectory is estimated
  std::vector<std::string> notes;  ///< what was chosen and what is doubtful, a sentence each

  std::size_t scans = 0;                             ///< received
  std::map<std::string, std::size_t> dropped_scans;  ///< by reason
  std::size_t poses = 0;                             ///< estimated, one per scan that was used
  std::size_t keyframes = 0;                         ///< scans that were kept for matching
  double way_m = 0.0;                                ///< driven, as tracked
  std::size_t tracking_searches = 0;                 ///< scans that a search has put right
  double odometry_noise_xy = 0.0;                    ///< as learnt, see OdometryNoise::scale_xy()
  double odometry_noise_yaw = 0.0;                   ///< as learnt, see OdometryNoise::scale_yaw()
  std::size_t loop_candidates = 0;                   ///< places that were searched
  std::map<std::string, std::size_t> loops;          ///< by verdict

  double recording_s = 0.0;        ///< from the first scan to the last
  double loop_candidate_ms = 0.0;  ///< elapsed time per candidate, solving the graph included
  double wall_s = 0.0;             ///< elapsed time, reading included
  double cpu_s = 0.0;              ///< user and system time
  double peak_memory_mib = 0.0;    ///< resident
};

/// Returns the summary as a JSON object with the id of the run.
std::string summary_to_json(const SlamSummary& summary, const std::string& run_id);

/// Returns the loops as a JSON object with the id of the run. A loop is the pose of the base at the
/// stamp `to` as seen from the base at the stamp `from` [m, rad].
std::string loops_to_json(const LevelSlamResult& result, const std::string& run_id);

/// Returns a few lines for a terminal.
std::string summary_text(const SlamSummary& summary);

}  // namespace ribbon_mapper::slam
