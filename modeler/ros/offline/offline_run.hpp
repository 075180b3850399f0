// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modeler/chain/matrix6.hpp"
#include "modeler/floor_plan/floor_plan.hpp"
#include "modeler/maps/model_maps.hpp"
#include "modeler/program/progress.hpp"
#include "modeler/ros/offline/offline_options.hpp"
#include "modeler/ros/offline/offline_summary.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/semantics/rooms.hpp"
#include "modeler/surface/plane.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper {

/// The results of modelling a recording.
struct OfflineRun {
  OfflineSummary summary;                              ///< without time and memory used
  std::vector<Plane> planes_before;                    ///< recorded poses, as built on the way
  std::vector<Plane> planes_after;                     ///< the final model
  std::vector<PlaneLabel> labels;                      ///< of its planes
  Rooms rooms;                                         ///< of the final model
  double stripe_gap_m = SurfaceConfig{}.stripe_gap_m;  ///< as configured, for the mesh
  std::string frame = "map";                           ///< frame of the model
  std::vector<StampedPose> trajectory_before;          ///< acquisition poses as recorded
  std::vector<StampedPose> trajectory;                 ///< acquisition poses of the final model
  std::string model_file;                              ///< bytes of a model file
  std::vector<Matrix6> covariances;                    ///< of an estimate, by pose of `trajectory`
  std::optional<ModelMaps> maps;                       ///< of the final model, if asked for
  FloorPlan floor_plan;                                ///< of the final model
  std::string command;                                 ///< the command line; may be empty
};

/// Models the bags and evaluates the model with the final poses. Throws std::runtime_error or
/// std::invalid_argument that says what is wrong with a bag, the preset or the trajectory, or why
/// no line could be modelled.
OfflineRun model_bags(const OfflineOptions& options, const ProgressCallback& progress);

/// What is written beside the model.
struct OfflineExtras {
  bool with_figure = false;              ///< draws model_views.png
  bool with_floor_plan = false;          ///< draws floor_plan.svg, .png and .dxf
  std::vector<MeshFormat> mesh_formats;  ///< writes planes_after.glb, for example
};

/// Writes the files of the model, floor_plan.geojson, report.html and the summary, and what is
/// asked for beside them. They are one set, see FileSet, and state the same run. Throws
/// std::runtime_error with the file, the reason and a remedy.
void write_model(const OfflineRun& run, const std::filesystem::path& directory,
                 const OfflineExtras& extras = {});

}  // namespace ribbon_mapper
