// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/program/progress.hpp"
#include "modeler/ros/offline/offline_options.hpp"
#include "modeler/ros/offline/offline_summary.hpp"
#include "modeler/surface/plane.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper {

/// What a run over a recording leaves.
struct OfflineRun {
  OfflineSummary summary;  ///< without what it cost
  std::vector<Plane> planes_before, planes_after;
  double stripe_gap_m = SurfaceConfig{}.stripe_gap_m;  ///< as configured, for the mesh
  std::vector<StampedPose> trajectory;                 ///< acquisition poses of the final model
};

/// Reads the bags through the intake of the node into the modeler, then evaluates the model with
/// the final poses. Throws std::runtime_error or std::invalid_argument that says what is wrong:
/// with a bag, a preset, the trajectory (another run's), or if no line could be placed.
OfflineRun model_bags(const OfflineOptions& options, const ProgressCallback& progress);

/// Writes the files that offline_modeler promises, each whole or not at all, but the summary.
void write_model(const OfflineRun& run, const std::filesystem::path& directory);

}  // namespace ribbon_mapper
