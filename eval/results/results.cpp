// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/results.hpp"

#include <array>
#include <cstdio>

#include "eval/metrics/outline_iou.hpp"
#include "eval/results/report_page.hpp"
#include "modeler/exports/exports.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/io/colour.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/save.hpp"
#include "modeler/io/tum.hpp"
#include "modeler/surface/outline.hpp"
#include "modeler/surface/surface_config.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper::eval {
namespace {

std::vector<Plane> planes_of(const std::vector<Patch>& truth) {
  std::vector<Plane> planes;
  for (const Patch& patch : truth) {
    planes.push_back(plane_of(patch, static_cast<std::int64_t>(planes.size())));
  }
  return planes;
}

std::string hex(const Colour& colour) {
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  return text.data();
}

/// Returns the figure's input beside the planes: outlines of the world and colours of the planes.
std::string figure_data(const Results& results, const std::string& run_id) {
  Json outlines = Json::array();
  for (const auto& polygon : results.world_outlines) {
    auto& points = outlines.emplace_back(Json::array());
    for (const Eigen::Vector2d& point : polygon) points.push_back({point.x(), point.y()});
  }
  Json colours = Json::object();
  for (const auto* planes : {&results.models.noisy, &results.models.corrected}) {
    for (const Plane& plane : *planes) {
      colours[std::to_string(plane.id)] = hex(plane_colour(plane.id));
    }
  }
  const Json data{{"run", run_id}, {"world_outlines", outlines}, {"colours", colours}};
  return data.dump() + "\n";
}

}  // namespace

void evaluate(Results& results) {
  const std::vector<Plane> truth = planes_of(results.truth);
  results.summary.metrics = for_each_model(results.models, [&](const std::vector<Plane>& planes) {
    MapMetrics metrics = compare_maps(patches_of(planes), results.truth);
    metrics.outline_iou = outline_iou(planes, truth, metrics.matches);
    return metrics;
  });
  if (results.trajectory_before.empty() || results.trajectory_truth.empty()) return;
  const Pose T_truth_estimate = results.trajectory_truth.back().T_map_base.inverse() *
                                results.trajectory_before.back().T_map_base;
  results.summary.end_drift_m = T_truth_estimate.translation().norm();
  results.summary.end_drift_deg = to_degrees(angle_of(T_truth_estimate));
}

FileSet staged_results(const Results& results, const std::filesystem::path& directory,
                       const std::vector<MeshFormat>& mesh_formats) {
  const std::vector<Plane> before = with_outlines(results.models.noisy_as_built, results.surface);
  const std::vector<Plane> truth = with_outlines(planes_of(results.truth), results.surface);
  ModelLabel label;
  label.run = run_id_of({planes_to_json(before), planes_to_json(results.models.noisy),
                         planes_to_json(results.models.corrected), planes_to_json(truth),
                         to_tum(results.trajectory_before), to_tum(results.trajectory_after)});
  FileSet files(directory, kResultsSet);
  files.add("summary.json", summary_to_json(results.summary, label.run));
  files.add("planes_before.json", planes_to_json(before, label));
  files.add("planes_noisy.json", planes_to_json(results.models.noisy, label));
  files.add("planes_truth.json", planes_to_json(truth, label));
  files.add("trajectory_before.tum", to_tum(results.trajectory_before, label.run));
  files.add("trajectory_after.tum", to_tum(results.trajectory_after, label.run));
  if (!results.covariances_after.empty()) {
    files.add(kCovarianceFile,
              to_covariance_csv(results.trajectory_after, results.covariances_after, label.run));
  }
  if (!results.trajectory_live.empty()) {
    files.add("trajectory_live.tum", to_tum(results.trajectory_live, label.run));
  }
  files.add("trajectory_truth.tum", to_tum(results.trajectory_truth, label.run));
  if (results.rooms) files.add("rooms.json", rooms_to_json(*results.rooms, label));
  if (results.floor_plan) add_floor_plan(*results.floor_plan, label, "floor_plan", files);
  files.add("figure.json", figure_data(results, label.run));
  files.add("report.html", report_page(results, before, truth, label.run));
  add_model(results.models.corrected, label, "planes_after", results.surface.stripe_gap_m, files,
            results.labels);
  add_meshes(results.models.corrected, label, results.labels, mesh_formats, "planes_after", files);
  return files;
}

void write_results(const Results& results, const std::filesystem::path& directory) {
  staged_results(results, directory).commit();
}

}  // namespace ribbon_mapper::eval
