// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "eval/metrics/patch.hpp"
#include "eval/results/summary.hpp"
#include "modeler/floor_plan/floor_plan.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/mesh/mesh_file.hpp"
#include "modeler/report/changed_keys.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/storage/file_set.hpp"
#include "modeler/surface/plane.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper::eval {

/// The planes of each of the four models.
using FourModels = PerModel<std::vector<Plane>>;

/// Everything that is kept of one run.
struct Results {
  Summary summary;                      ///< metrics and times
  FourModels models;                    ///< before and after the correction, as built and final
  std::vector<PlaneLabel> labels;       ///< of the corrected, final planes; empty: none are written
  std::optional<Rooms> rooms;           ///< of the same planes
  std::optional<FloorPlan> floor_plan;  ///< of the same planes
  std::vector<Patch> truth;             ///< the true planes
  /// Acquisition poses of the lines before the correction.
  std::vector<StampedPose> trajectory_before;
  /// Acquisition poses of the lines after the correction.
  std::vector<StampedPose> trajectory_after;
  /// Their covariances, see to_covariance_csv(); none if the truth has corrected them.
  std::vector<Matrix6> covariances_after;
  /// The poses that lines had when they were the newest; none if the truth has corrected them.
  std::vector<StampedPose> trajectory_live;
  /// True acquisition poses of the lines.
  std::vector<StampedPose> trajectory_truth;
  /// Polylines of the world in a top view [m], for the figure.
  std::vector<std::vector<Eigen::Vector2d>> world_outlines;
  SurfaceConfig surface;  ///< the modeler's
  /// Keys of the modeler's configuration that are not at their defaults, if known.
  std::optional<std::vector<ChangedKey>> parameters;
};

/// Computes the metrics of the four models and the end drift, and stores them in the summary.
void evaluate(Results& results);

/// Writes the results as new files of the set kResultsSet in `directory`, which is created if
/// needed, and returns the set to be committed. All files state the same run. They are
/// summary.json, planes_before.json (noisy, as built), planes_noisy.json (noisy, final),
/// planes_truth.json, planes_after.{json,ply,bt} with planes_after_cells.ply (corrected, final),
/// planes_after.{glb,obj,stl} as the formats demand, rooms.json (if there are rooms),
/// floor_plan.geojson (if there is a floor plan), trajectory_{before,after,truth}.tum,
/// trajectory_live.tum and trajectory_covariance.csv (if there are any), figure.json (for
/// draw_figure()) and report.html (see report_page()). Throws std::runtime_error with the file, the
/// reason and a remedy.
FileSet staged_results(const Results& results, const std::filesystem::path& directory,
                       const std::vector<MeshFormat>& mesh_formats = {});

/// Writes the results as staged_results() and commits them.
void write_results(const Results& results, const std::filesystem::path& directory);

}  // namespace ribbon_mapper::eval
