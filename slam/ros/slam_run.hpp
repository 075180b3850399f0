// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/program/progress.hpp"
#include "slam/level/level_slam.hpp"
#include "slam/ros/slam_options.hpp"
#include "slam/ros/slam_summary.hpp"

namespace ribbon_mapper::slam {

/// The results of `offline_slam`.
struct SlamRun {
  SlamSummary summary;                  ///< without time and memory used
  LevelSlamResult result;               ///< in a map whose origin is the first pose
  std::vector<Eigen::Vector2d> points;  ///< of all keyframes, in map [m], one per 5 cm square
};

/// Estimates the trajectory of the bags. Throws std::runtime_error that says what is wrong with a
/// bag, or why no scan could be used.
SlamRun run_slam(const SlamOptions& options, const ProgressCallback& progress);

/// Writes the files of the results, and draws level_map.png if asked to. They are one set, see
/// FileSet, and state the same run. Throws std::runtime_error with the file, the reason and a
/// remedy.
void write_slam(const SlamRun& run, const std::filesystem::path& directory, bool with_figure);

}  // namespace ribbon_mapper::slam
