// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <utility>

#include "bench/child.hpp"
#include "bench/planes/judge.hpp"
#include "bench/planes/planes_peer.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr float kVoxel_m = 0.04F;
constexpr std::size_t kLinesPerSweep = 60;  // a half-period of the tilt
constexpr std::size_t kDenseVoxel = 5;      // points per voxel above which a cloud is dense

/// Measures time and accuracy of all methods on a recording, with poses of one kind.
class Contest {
 public:
  Contest(const Inputs& inputs, Report& report, Poses poses, std::string section)
      : inputs_(inputs),
        report_(report),
        poses_(poses),
        section_(std::move(section)),
        cloud_(cloud_of(inputs.recording, inputs.config.scan, poses)),
        views_(cloud_) {}

  /// Measures our method line by line with noisy poses, plus the correction if poses are to be
  /// true.
  void ours() {
    std::vector<double> seconds;
    nlohmann::json metrics;
    double peak_mb = 0.0;
    const int runs =
        std::min(3, inputs_.options.repetitions) * repetitions_factor(inputs_.recording);
    for (int i = 0; i < runs; ++i) {
      const auto result = run_in_child([this] { return our_run(); }, inputs_.options.limit_s);
      if (!result) return;
      seconds.push_back(result->value["seconds"]);
      metrics = result->value["metrics"];
      peak_mb = result->peak_mb;
    }
    ours_s_ = median(seconds);
    f1 = metrics.value("f1", 0.0);
    report_.add({section_,
                 poses_ == Poses::truth ? "ours: lines, correction, planes" : "ours: lines, planes",
                 ours_s_, item_ns(ours_s_), 1.0, peak_mb, text_of(metrics), metrics});
  }

  /// Measures a peer. Returns its CPU time, or infinity if it was stopped.
  double peer(const std::string& name, const std::function<std::vector<Points>()>& planes_of,
              bool is_per_sweep = false) {
    const auto work = [&]() -> nlohmann::json {
      const double before_mb = resident_mb();
      std::vector<Points> planes;
      const double seconds = cpu_seconds_of([&] { planes = planes_of(); });
      const double peak_mb = peak_resident_mb() - before_mb;
      if (is_per_sweep) planes = united(planes);
      return {{"seconds", seconds},
              {"metrics", judged(bounded_planes(planes, views_, inputs_.config))},
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
    best_peer_f1 = std::max(best_peer_f1, metrics.value("f1", 0.0));
    return seconds;
  }

  /// Measures peers on the raw points and returns the CPU time of the fastest.
  double raw_peers(Density density) {
    const auto on_raw = [this](const PlanesPeer& p) {
      return peer(p.name + ", raw", [&] { return p.planes_of(cloud_.points); });
    };
    return std::min({on_raw(pcl_region_growing(density)), on_raw(cgal_region_growing(density)),
                     on_raw(cgal_efficient_ransac(density))});
  }

  /// Measures PCL's organised segmentation and returns its CPU time. As it does not merge planes of
  /// different sweeps, it is not comparable with the other peers.
  double sweeps_peer() {
    const auto sweeps = sweeps_of(inputs_.recording, inputs_.config.scan, poses_, kLinesPerSweep);
    return peer(
        "PCL organised multi-plane, per sweep; merged by us",
        [&] { return pcl_organised_planes(sweeps); }, true);
  }

  /// Measures peers on voxel centroids and returns the CPU time of the fastest.
  double voxel_peers() {
    const auto on_voxels = [this](const PlanesPeer& p) {
      return peer(p.name + ", 4 cm voxels",
                  [&] { return p.planes_of(voxel_grid(cloud_.points, kVoxel_m)); });
    };
    return std::min({on_voxels(pcl_region_growing(Density::sparse)),
                     on_voxels(cgal_region_growing(Density::sparse)),
                     on_voxels(cgal_efficient_ransac(Density::sparse))});
  }

  /// Returns the density of the recording's raw points.
  Density raw_density() const {
    const std::size_t voxels = voxel_grid(cloud_.points, kVoxel_m).size();
    return cloud_.points.size() > kDenseVoxel * voxels ? Density::dense : Density::sparse;
  }

  /// Returns the ratio of a peer's CPU time to ours; a stopped peer counts with the limit.
  double over_ours(double seconds) const {
    return std::min(seconds, inputs_.options.limit_s) / ours_s_;
  }
  double f1 = 0.0, best_peer_f1 = 0.0;  ///< 0 without a ground truth

 private:
  double item_ns(double seconds) const {
    return 1e9 * seconds / static_cast<double>(cloud_.points.size());
  }
  nlohmann::json judged(const std::vector<Plane>& planes) const {
    if (inputs_.recording.truth.empty()) {
      return judged_by_points(planes, cloud_.points, inputs_.config);
    }
    return to_json(eval::compare_maps(eval::patches_of(planes), inputs_.recording.truth));
  }

  nlohmann::json our_run() const {
    Modeler modeler(inputs_.config);
    std::vector<Plane> planes;
    const auto truth = true_trajectory(inputs_.recording);
    const double seconds = cpu_seconds_of([&] {
      for (const RecordedLine& line : inputs_.recording.lines) {
        modeler.add_scan_line(line.beams, line.poses);
      }
      if (poses_ == Poses::truth) modeler.correct(truth);
      planes = modeler.planes();
    });
    return {{"seconds", seconds}, {"metrics", judged(planes)}};
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
  for (const Poses poses : {Poses::truth, Poses::noisy}) {
    const bool is_true = poses == Poses::truth;
    Contest contest(inputs, report, poses,
                    is_true ? "planes of the tour, true poses" : "planes of the tour, noisy poses");
    contest.ours();
    const double voxels_s = contest.voxel_peers(), sweeps_s = contest.sweeps_peer(),
                 raw_s = contest.raw_peers(Density::dense);
    const std::string kind = is_true ? "" : "_noisy";
    report.set("f1" + kind, contest.f1);
    report.set("best_peer_f1" + kind, contest.best_peer_f1);
    if (!is_true) continue;
    report.set("planes_vs_best_raw_peer", contest.over_ours(raw_s));
    report.set("planes_vs_best_voxel_peer", contest.over_ours(voxels_s));
    report.set("planes_vs_organised_sweeps", contest.over_ours(sweeps_s));
  }
}

void measure_recorded_planes(const Inputs& inputs, Report& report) {
  Contest contest(inputs, report, Poses::truth, "planes, poses as recorded");
  contest.ours();
  report.set("planes_vs_best_voxel_peer", contest.over_ours(contest.voxel_peers()));
  report.set("planes_vs_best_raw_peer",
             contest.over_ours(contest.raw_peers(contest.raw_density())));
}

}  // namespace ribbon_mapper::bench
