// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/results.hpp"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "modeler/geometry/angles.hpp"
#include "modeler/io/atomic_file.hpp"
#include "modeler/io/colour.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/save.hpp"
#include "modeler/io/tum.hpp"
#include "modeler/surface/outline.hpp"
#include "modeler/surface/surface_config.hpp"

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
std::string figure_data(const Results& results) {
  nlohmann::ordered_json outlines = nlohmann::ordered_json::array();
  for (const auto& polygon : results.world_outlines) {
    auto& points = outlines.emplace_back(nlohmann::ordered_json::array());
    for (const Eigen::Vector2d& point : polygon) points.push_back({point.x(), point.y()});
  }
  nlohmann::ordered_json colours = nlohmann::ordered_json::object();
  for (const auto* planes : {&results.models.noisy, &results.models.corrected}) {
    for (const Plane& plane : *planes) {
      colours[std::to_string(plane.id)] = hex(plane_colour(plane.id));
    }
  }
  return nlohmann::ordered_json{{"world_outlines", outlines}, {"colours", colours}}.dump() + "\n";
}

/// Adds the outlines that planes as built do not have.
std::vector<Plane> with_outlines(std::vector<Plane> planes) {
  for (Plane& plane : planes) {
    if (plane.outline.empty()) plane.outline = outline_of(plane, SurfaceConfig().bridged_gap_m);
  }
  return planes;
}

}  // namespace

void evaluate(Results& results) {
  results.summary.metrics = for_each_model(results.models, [&](const std::vector<Plane>& planes) {
    return compare_maps(patches_of(planes), results.truth);
  });
  if (results.trajectory_before.empty() || results.trajectory_truth.empty()) return;
  const Pose T_truth_estimate = results.trajectory_truth.back().T_map_base.inverse() *
                                results.trajectory_before.back().T_map_base;
  results.summary.end_drift_m = T_truth_estimate.translation().norm();
  results.summary.end_drift_deg = to_degrees(angle_of(T_truth_estimate));
}

void write_results(const Results& results, const std::filesystem::path& directory) {
  create_directory_for_files(directory);
  write_file_atomically(directory / "summary.json", summary_to_json(results.summary));
  write_file_atomically(directory / "planes_before.json",
                        planes_to_json(with_outlines(results.models.noisy_as_built)));
  write_file_atomically(directory / "planes_noisy.json", planes_to_json(results.models.noisy));
  write_file_atomically(directory / "planes_truth.json",
                        planes_to_json(with_outlines(planes_of(results.truth))));
  write_file_atomically(directory / "trajectory_before.tum", to_tum(results.trajectory_before));
  write_file_atomically(directory / "trajectory_after.tum", to_tum(results.trajectory_after));
  write_file_atomically(directory / "trajectory_truth.tum", to_tum(results.trajectory_truth));
  write_file_atomically(directory / "figure.json", figure_data(results));
  save_model(results.models.corrected, directory, "planes_after", SurfaceConfig{}.stripe_gap_m);
}

}  // namespace ribbon_mapper::eval
