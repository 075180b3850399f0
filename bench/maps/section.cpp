// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "bench/child.hpp"
#include "bench/correction/octomap_rebuild.hpp"
#include "bench/lines/line_times.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"
#include "modeler/maps/model_maps.hpp"
#include "modeler/observations/observations.hpp"

namespace ribbon_mapper::bench {
namespace {

const std::string kSection = "free space: from lines and true poses to a map of free and occupied";

/// Models the tour, corrects it by the true poses and makes the maps.
nlohmann::json our_maps(const Inputs& inputs) {
  Modeler modeler(inputs.config);
  feed(inputs.recording, modeler);
  const double correct_s =
      cpu_seconds_of([&] { modeler.correct(true_trajectory(inputs.recording)); });
  PlaneModel model;
  const double planes_s = cpu_seconds_of([&] { model = modeler.plane_model(); });
  SightLines sights;
  const double copy_s = cpu_seconds_of(
      [&] { sights = sight_lines_of(modeler.observations().posed(), model, inputs.config.maps); });
  std::size_t bytes = 0, cells = 0;
  const double carve_s = cpu_seconds_of([&] {
    const ModelMaps maps = make_maps(model.planes, sights, inputs.config.maps);
    bytes = maps.voxels.memory_bytes(), cells = maps.level.cells.size();
  });
  return {{"seconds", copy_s + carve_s},
          {"copy_s", copy_s},
          {"carve_s", carve_s},
          {"after_correction_s", correct_s + planes_s + copy_s + carve_s},
          {"lines", sights.lines.size()},
          {"copy_bytes", sights.memory_bytes()},
          {"map_bytes", bytes},
          {"cells", cells}};
}

nlohmann::json octomap(const Inputs& inputs, Insertion insertion) {
  const OctomapResult result = rebuild_octomap(inputs.recording, inputs.config.scan, insertion);
  return {{"seconds", result.seconds}, {"tree_bytes", result.tree_bytes}};
}

std::string text_of(const nlohmann::json& ours) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%zu lines; copy %.1f ms and %.1f MB, carving %.0f ms and %.1f MB; correct() and "
                "planes() before it: %.0f ms",
                ours["lines"].get<std::size_t>(), 1e3 * ours["copy_s"].get<double>(),
                1e-6 * ours["copy_bytes"].get<double>(), 1e3 * ours["carve_s"].get<double>(),
                1e-6 * ours["map_bytes"].get<double>(),
                1e3 * (ours["after_correction_s"].get<double>() - ours["seconds"].get<double>()));
  return text;
}

}  // namespace

void measure_maps(const Inputs& inputs, Report& report) {
  const auto ours = run_in_child([&] { return our_maps(inputs); }, inputs.options.limit_s);
  if (!ours) return;
  const double ours_s = ours->value["seconds"];
  const double after_correction_s = ours->value["after_correction_s"];
  report.add({kSection,
              "ours: sight lines, voxels and the level map",
              ours_s,
              {},
              1.0,
              ours->peak_mb,
              text_of(ours->value),
              ours->value});
  const auto add = [&](const std::string& name, const std::string& ratio, Insertion insertion) {
    const auto tree =
        run_in_child([&] { return octomap(inputs, insertion); }, inputs.options.limit_s);
    if (!tree) return;
    const double seconds = tree->value["seconds"];
    report.add({kSection, name, seconds, {}, seconds / ours_s, tree->peak_mb, "", tree->value});
    report.set("maps_vs_" + ratio, seconds / ours_s);
    report.set("corrected_maps_vs_" + ratio, seconds / after_correction_s);
  };
  add("OctoMap 5 cm, insertPointCloud, lazy and discretised", "octomap_fast", Insertion::fast);
  if (!inputs.options.quick) {
    add("OctoMap 5 cm, insertPointCloud", "octomap", Insertion::as_documented);
  }
}

}  // namespace ribbon_mapper::bench
