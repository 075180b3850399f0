// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "eval/metrics/patch.hpp"
#include "eval/results/summary.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::eval {

using FourModels = PerModel<std::vector<Plane>>;

/// What a tour leaves behind.
struct Results {
  Summary summary;
  FourModels models;
  std::vector<Patch> truth;
  // Acquisition poses.
  std::vector<StampedPose> trajectory_before;
  std::vector<StampedPose> trajectory_after;
  std::vector<StampedPose> trajectory_truth;
  /// Lines of the world in a top view, for the figure [m].
  std::vector<std::vector<Eigen::Vector2d>> world_outlines;
};

/// Fills in the parts of the summary that follow from the rest: the four cells and the end drift.
void evaluate(Results& results);

/// Writes into `directory` (created where needed), each file whole or not at all: summary.json,
/// planes_before.json (noisy, as built), planes_noisy.json, planes_truth.json, the model
/// planes_after.{json,ply,bt} with planes_after_cells.ply (corrected, merged),
/// trajectory_{before,after,truth}.tum and figure.json, all that draw_figure() reads. Throws
/// std::runtime_error (which file, why, what to do).
void write_results(const Results& results, const std::filesystem::path& directory);

}  // namespace ribbon_mapper::eval
