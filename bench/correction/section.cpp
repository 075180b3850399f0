// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "bench/child.hpp"
#include "bench/correction/octomap_rebuild.hpp"
#include "bench/correction/ribbon_floor.hpp"
#include "bench/lines/line_times.hpp"
#include "bench/planes/judge.hpp"
#include "bench/planes/planes_peer.hpp"
#include "bench/scale/tiles.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

const std::string kSection = "after a loop closure: from true poses to a map";

nlohmann::json judged(const std::vector<Plane>& planes, const Recording& tour) {
  return to_json(eval::compare_maps(eval::patches_of(planes), tour.truth));
}

/// Models the whole tour with noisy poses, then corrects it by the true ones.
nlohmann::json our_correction(const Inputs& inputs) {
  Modeler modeler(inputs.config);
  feed(inputs.recording, modeler);
  const auto truth = true_trajectory(inputs.recording);
  std::vector<Plane> planes;
  const double correct_s = cpu_seconds_of([&] { modeler.correct(truth); });
  const double planes_s = cpu_seconds_of([&] { planes = modeler.planes(); });
  return {{"correct_s", correct_s},
          {"planes_s", planes_s},
          {"seconds", correct_s + planes_s},
          {"ribbons", modeler.statistics().ribbons},
          {"metrics", judged(planes, inputs.recording)}};
}

/// Corrects the whole tour, then revises the poses of its last 12 s, as an estimate of the
/// trajectory does every few seconds.
nlohmann::json our_revision(const Inputs& inputs) {
  constexpr double kWindow_s = 12.0;
  Modeler modeler(inputs.config);
  feed(inputs.recording, modeler);
  const auto whole = bent(true_trajectory(inputs.recording), 1.0);
  const auto revised = bent(whole, std::min(1.0, kWindow_s / inputs.recording.duration_s));
  modeler.correct(true_trajectory(inputs.recording));
  const double whole_s = cpu_seconds_of([&] { modeler.correct(whole); });
  const double whole_planes_s = cpu_seconds_of([&] { modeler.planes(); });
  const std::size_t before = modeler.statistics().associated_again;
  const double correct_s = cpu_seconds_of([&] { modeler.correct(revised); });
  const double planes_s = cpu_seconds_of([&] { modeler.planes(); });
  return {{"seconds", correct_s + planes_s},
          {"correct_s", correct_s},
          {"over_correction", correct_s / whole_s},
          {"with_planes", (correct_s + planes_s) / (whole_s + whole_planes_s)},
          {"associated_again", modeler.statistics().associated_again - before},
          {"ribbons", modeler.statistics().ribbons}};
}

/// Models the tour from scratch with true poses and the gates for corrected poses.
nlohmann::json our_rebuild(const Inputs& inputs) {
  ModelerConfig config = inputs.config;
  config.association.slam = config.association.corrected;
  std::vector<LinePoses> poses;
  for (const RecordedLine& line : inputs.recording.lines) poses.push_back(with_true_pose(line));
  std::vector<Plane> planes;
  const double seconds = cpu_seconds_of([&] {
    Modeler modeler(config);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      modeler.add_scan_line(inputs.recording.lines[i].beams, poses[i]);
    }
    planes = modeler.planes();
  });
  return {{"seconds", seconds}, {"metrics", judged(planes, inputs.recording)}};
}

nlohmann::json octomap(const Inputs& inputs, Insertion insertion) {
  const OctomapResult result = rebuild_octomap(inputs.recording, inputs.config.scan, insertion);
  return {
      {"seconds", result.seconds}, {"tree_bytes", result.tree_bytes}, {"leaves", result.leaves}};
}

/// Runs a peer on all points at their true poses; placing the points is included.
nlohmann::json on_voxels(const Inputs& inputs, const PlanesPeer& peer) {
  TourCloud cloud;
  std::vector<Points> planes;
  const double seconds = cpu_seconds_of([&] {
    cloud = cloud_of(inputs.recording, inputs.config.scan, Poses::truth);
    planes = peer.planes_of(voxel_grid(cloud.points, 0.04F));
  });
  return {{"seconds", seconds},
          {"metrics",
           judged(bounded_planes(planes, ViewField(cloud), inputs.config), inputs.recording)}};
}

/// Returns the median of several runs in child processes, or nothing if one exceeds the limit.
std::optional<ChildResult> median_run(const std::function<nlohmann::json()>& work, int repetitions,
                                      double limit_s) {
  std::vector<ChildResult> runs;
  for (int i = 0; i < repetitions; ++i) {
    const auto run = run_in_child(work, limit_s);
    if (!run) return std::nullopt;
    runs.push_back(*run);
  }
  std::sort(runs.begin(), runs.end(), [](const ChildResult& a, const ChildResult& b) {
    return a.value["seconds"].get<double>() < b.value["seconds"].get<double>();
  });
  return runs[runs.size() / 2];
}

class Section {
 public:
  Section(const Inputs& inputs, Report& report) : inputs_(inputs), report_(report) {}

  /// Runs the work, adds a row and returns its CPU time, or the limit if it was stopped.
  double add(const std::string& name, const std::function<nlohmann::json()>& work,
             int repetitions = 1) {
    const double limit_s = inputs_.options.limit_s;
    const auto run = median_run(work, repetitions, limit_s);
    if (!run) {
      report_.add({kSection, name, {}, {}, limit_s / ours_s, {}, "stopped at the limit", {}});
      return limit_s;
    }
    last = run->value;
    const double seconds = last["seconds"];
    if (ours_s == 0.0) ours_s = seconds;
    report_.add({kSection,
                 name,
                 seconds,
                 {},
                 seconds / ours_s,
                 run->peak_mb,
                 last.contains("metrics") ? text_of(last["metrics"]) : "",
                 last});
    return seconds;
  }

  double ours_s = 0.0;
  nlohmann::json last;

 private:
  const Inputs& inputs_;
  Report& report_;
};

double floor_s(const Inputs& inputs, Report& report) {
  Modeler modeler(inputs.config);
  feed(inputs.recording, modeler);
  RibbonFloor floor(modeler);
  std::vector<double> seconds;
  for (int i = 0; i < 21; ++i) {
    seconds.push_back(cpu_seconds_of([&] { floor.move(modeler.trajectory()); }));
  }
  char text[96];
  std::snprintf(text, sizeof text, "%zu ribbons, %zu samples", floor.ribbons(), floor.samples());
  report.add({kSection,
              "lower bound: every ribbon's moments and samples moved once",
              median(seconds),
              {},
              {},
              {},
              text,
              {}});
  return median(seconds);
}

}  // namespace

void measure_corrections(const Inputs& inputs, Report& report) {
  Section section(inputs, report);
  const int repetitions = inputs.options.repetitions;
  const double ours_s = section.add(
      "ours: correct() and planes(), cells included", [&] { return our_correction(inputs); },
      repetitions);
  report.set("correction_s", ours_s);
  report.set("correction_correct_s", section.last["correct_s"]);
  report.set("correction_planes_s", section.last["planes_s"]);
  report.set("correction_over_floor", ours_s / floor_s(inputs, report));
  section.add(
      "ours, the last 12 s revised: correct() and planes()", [&] { return our_revision(inputs); },
      repetitions);
  report.set("revision_over_correction", section.last["over_correction"]);
  report.set("revision_with_planes", section.last["with_planes"]);
  report.set("correction_vs_rebuild",
             section.add(
                 "ours, rebuilt from all lines", [&] { return our_rebuild(inputs); },
                 std::min(3, repetitions)) /
                 ours_s);
  const double fast_s = section.add("OctoMap 5 cm, insertPointCloud, lazy and discretised",
                                    [&] { return octomap(inputs, Insertion::fast); });
  report.set("correction_vs_octomap_fast", fast_s / ours_s);
  if (!inputs.options.quick) {
    const double octomap_s = section.add("OctoMap 5 cm, insertPointCloud",
                                         [&] { return octomap(inputs, Insertion::as_documented); });
    report.set("correction_vs_octomap", octomap_s / ours_s);
  }
  for (const PlanesPeer& peer :
       {pcl_region_growing(Density::sparse), cgal_region_growing(Density::sparse),
        cgal_efficient_ransac(Density::sparse)}) {
    section.add(peer.name + ", 4 cm voxels", [&] { return on_voxels(inputs, peer); });
  }
}

void measure_memory(const Inputs& inputs, Report& report) {
  double area_m2 = 0.0;  // stays 0 for bags, which have no ground truth
  for (const eval::Patch& patch : inputs.recording.truth) area_m2 += patch.area_m2;
  const auto add = [&](const std::string& name, double bytes, const std::string& text) {
    char details[160], per_m2[48] = "";
    if (area_m2 > 0.0) {
      std::snprintf(per_m2, sizeof per_m2, ", %.0f bytes per m2 of true planes", bytes / area_m2);
    }
    std::snprintf(details, sizeof details, "%.2f MB%s%s", 1e-6 * bytes, per_m2, text.c_str());
    report.add(
        {"memory of the model", name, {}, {}, {}, 1e-6 * bytes, details, {{"bytes", bytes}}});
  };
  const auto ours = run_in_child(
      [&]() -> nlohmann::json {
        Modeler modeler(inputs.config);
        feed(inputs.recording, modeler);
        return {{"bytes", modeler.memory_bytes()}, {"resident_mb", resident_mb()}};
      },
      inputs.options.limit_s);
  const double bytes = ours->value["bytes"];
  add("ours: Modeler::memory_bytes()", bytes,
      "; process grew by " + std::to_string(static_cast<int>(ours->peak_mb)) + " MB at most");
  const auto tree =
      run_in_child([&] { return octomap(inputs, Insertion::fast); }, inputs.options.limit_s);
  const double raw_bytes = 4.0 * static_cast<double>(inputs.recording.beam_count());
  if (tree) {
    const double tree_bytes = tree->value["tree_bytes"];
    add("OctoMap 5 cm: OcTree::memoryUsage()", tree_bytes, "");
    report.set("memory_vs_octomap", bytes / tree_bytes);
  }
  add("raw ranges, 4 bytes a beam", raw_bytes, "");
  report.set("memory_vs_raw", bytes / raw_bytes);
  if (area_m2 > 0.0) report.set("memory_bytes_per_m2", bytes / area_m2);
}

}  // namespace ribbon_mapper::bench
