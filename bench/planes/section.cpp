// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "bench/child.hpp"
#include "bench/planes/judge.hpp"
#include "bench/planes/planes_peer.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr float kVoxel_m = 0.04F;
constexpr std::size_t kLinesPerSweep = 60;  // half a period of the tilt

/// Times and judges all ways to the planes of the tour, for poses of one kind.
class Contest {
 public:
  Contest(const Inputs& inputs, Report& report, Poses poses)
      : inputs_(inputs),
        report_(report),
        poses_(poses),
        section_(poses == Poses::true_ones ? "planes of the tour, true poses"
                                           : "planes of the tour, believed poses"),
        cloud_(cloud_of(inputs.tour, inputs.config.scan, poses)),
        views_(cloud_) {}

  /// Line by line with the believed poses; for the true ones the correction comes on top.
  void ours() {
    std::vector<double> seconds;
    nlohmann::json metrics;
    double peak_mb = 0.0;
    for (int i = 0; i < std::min(3, inputs_.options.repetitions); ++i) {
      const auto result = run_in_child([this] { return our_run(); }, inputs_.options.limit_s);
      if (!result) return;
      seconds.push_back(result->value["seconds"]);
      metrics = result->value["metrics"];
      peak_mb = result->peak_mb;
    }
    ours_s_ = median(seconds);
    f1 = metrics["f1"];
    report_.add(
        {section_,
         poses_ == Poses::true_ones ? "ours: lines, correction, planes" : "ours: lines, planes",
         ours_s_, item_ns(ours_s_), 1.0, peak_mb, text_of(metrics), metrics});
  }

  /// Returns the seconds, infinite if it did not finish.
  double peer(const std::string& name, const std::function<std::vector<Points>()>& planes_of,
              bool is_to_be_united = false) {
    const auto work = [&]() -> nlohmann::json {
      const double before_mb = resident_mb();
      std::vector<Points> planes;
      const double seconds = seconds_of([&] { planes = planes_of(); });
      const double peak_mb = peak_resident_mb() - before_mb;
      if (is_to_be_united) planes = united(planes);
      return {{"seconds", seconds},
              {"metrics", judged(patches_of(planes, views_, least_m2()))},
              {"peak_mb", peak_mb}};
    };
    const auto result = run_in_child(work, inputs_.options.limit_s);
    if (!result) {
      report_.add({section_,
                   name,
                   {},
                   {},
                   inputs_.options.limit_s / ours_s_,
                   {},
                   "stopped at the limit of CPU time",
                   {}});
      return std::numeric_limits<double>::infinity();
    }
    const double seconds = result->value["seconds"];
    const nlohmann::json& metrics = result->value["metrics"];
    report_.add({section_, name, seconds, item_ns(seconds), seconds / ours_s_,
                 result->value["peak_mb"].get<double>(), text_of(metrics), metrics});
    best_peer_f1 = std::max(best_peer_f1, metrics["f1"].get<double>());
    return seconds;
  }

  /// Returns the seconds of the fastest.
  double raw_peers() {
    const auto on_raw = [this](const PlanesPeer& p) {
      return peer(p.name + ", raw", [&] { return p.planes_of(cloud_.points); });
    };
    const auto sweeps = sweeps_of(inputs_.tour, inputs_.config.scan, poses_, kLinesPerSweep);
    // No planes of the tour: PCL does not unite those of the sweeps. So it is no rival of the
    // others.
    per_sweep_s = peer(
        "PCL organised multi-plane, per sweep; united by us",
        [&] { return pcl_organised_planes(sweeps); }, true);
    return std::min({on_raw(pcl_region_growing(Density::raw)),
                     on_raw(cgal_region_growing(Density::raw)),
                     on_raw(cgal_efficient_ransac(Density::raw))});
  }

  double voxel_peers() {
    const auto on_voxels = [this](const PlanesPeer& p) {
      return peer(p.name + ", 4 cm voxels",
                  [&] { return p.planes_of(voxel_grid(cloud_.points, kVoxel_m)); });
    };
    return std::min({on_voxels(pcl_region_growing(Density::voxels)),
                     on_voxels(cgal_region_growing(Density::voxels)),
                     on_voxels(cgal_efficient_ransac(Density::voxels))});
  }

  double ours_s() const { return ours_s_; }
  double f1 = 0.0, best_peer_f1 = 0.0, per_sweep_s = 0.0;

 private:
  double least_m2() const { return inputs_.config.map.least_area_m2; }
  double item_ns(double seconds) const {
    return 1e9 * seconds / static_cast<double>(cloud_.points.size());
  }
  nlohmann::json judged(const std::vector<eval::Patch>& patches) const {
    return to_json(eval::compare_maps(patches, inputs_.tour.truth));
  }

  nlohmann::json our_run() const {
    Modeler modeler(inputs_.config);
    std::vector<Plane> planes;
    const auto truth = true_trajectory(inputs_.tour);
    const double seconds = seconds_of([&] {
      for (const RecordedLine& line : inputs_.tour.lines) {
        modeler.add_scan_line(line.beams, line.poses);
      }
      if (poses_ == Poses::true_ones) modeler.correct(truth);
      planes = modeler.merged_planes();
    });
    return {{"seconds", seconds}, {"metrics", judged(eval::patches_of(planes))}};
  }

  const Inputs& inputs_;
  Report& report_;
  Poses poses_;
  std::string section_;
  TourCloud cloud_;
  ViewField views_;
  double ours_s_ = 0.0;
};

}  // namespace

void measure_planes(const Inputs& inputs, Report& report) {
  for (const Poses poses : {Poses::true_ones, Poses::believed}) {
    Contest contest(inputs, report, poses);
    contest.ours();
    const double voxels_s = contest.voxel_peers(), raw_s = contest.raw_peers();
    if (poses != Poses::true_ones) {
      report.set("f1_believed", contest.f1);
      report.set("best_peer_f1_believed", contest.best_peer_f1);
      continue;
    }
    // A peer that was stopped counts with the time that it was given.
    const double limit_s = inputs.options.limit_s;
    report.set("planes_vs_best_raw_peer", std::min(raw_s, limit_s) / contest.ours_s());
    report.set("planes_vs_best_voxel_peer", std::min(voxels_s, limit_s) / contest.ours_s());
    report.set("planes_vs_organised_sweeps", contest.per_sweep_s / contest.ours_s());
    report.set("f1", contest.f1);
    report.set("best_peer_f1", contest.best_peer_f1);
  }
}

}  // namespace ribbon_mapper::bench
