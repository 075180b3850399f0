// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/experiment.hpp"

#include <algorithm>

#include "eval/experiment/self_closure.hpp"
#include "eval/experiment/sim_conversion.hpp"
#include "eval/metrics/statistics.hpp"
#include "eval/results/world_outlines.hpp"
#include "eval/segmentation/point_truth.hpp"
#include "eval/semantics/true_labels.hpp"
#include "modeler/modeler.hpp"
#include "modeler/program/stopwatch.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::eval {
namespace {

/// Number of dropped lines and computing times of all lines.
struct LineLog {
  std::size_t dropped = 0;
  double total_s = 0.0;
  std::vector<double> line_s;
};

bool is_dropped(LineResult result) {
  return result == LineResult::malformed || result == LineResult::out_of_order;
}

/// Ground truth of the planes and of each beam.
struct Truth {
  explicit Truth(const sim::World& world) : collector(world) {}
  void add(const sim::Scan& scan) { points.add(middle_of(beams_of(scan)), collector.add(scan)); }

  sim::TruthCollector collector;
  PointTruth points;
};

LineLog drive(sim::Tour& tour, Modeler& modeler, SelfClosure* closure, Truth& truth,
              const ProgressCallback& progress) {
  LineLog log;
  while (const std::optional<sim::Scan> scan = tour.next_scan()) {
    const LaserBeams beams = beams_of(*scan);
    const LinePoses poses = noisy_poses(tour, beams);
    LineResult result = LineResult::modelled;
    log.line_s.push_back(wall_seconds_of([&] { result = modeler.add_scan_line(beams, poses); }));
    log.total_s += log.line_s.back();
    if (closure != nullptr) closure->update(tour, middle_of(beams));
    log.dropped += is_dropped(result) ? 1 : 0;
    truth.add(*scan);
    progress({log.line_s.size(), tour.line_count(), modeler.statistics().ribbons,
              to_seconds(beams.stamp), log.total_s});
  }
  return log;
}

PointMetrics point_metrics(const PointTruth& truth, const Modeler& modeler,
                           const std::vector<Plane>& planes) {
  const Overlaps of_ribbons = truth.overlaps(modeler, planes, PointTruth::Points::of_ribbons);
  const Overlaps all = truth.overlaps(modeler, planes, PointTruth::Points::all);
  return {segcomp(of_ribbons), evops(of_ribbons), duplication(of_ribbons), segcomp(all)};
}

/// Compares planes with the truth, and their labels if the world says what its shapes are.
void evaluate_planes(Results& results, const sim::World& world, const Truth& truth) {
  evaluate(results);
  const std::vector<Plane>& planes = results.models.corrected;
  const Semantics semantics = semantics_of(planes, positions_of(results.trajectory_after));
  results.labels = plane_labels(planes, semantics, {});
  results.rooms = rooms_of(planes, semantics, results.surface.stripe_gap_m);
  results.floor_plan = floor_plan_of(planes, semantics, *results.rooms);
  const std::vector<LabelledCell> cells = labelled_cells(world, truth.collector.cells());
  if (!cells.empty()) {
    results.summary.labels = label_confusion(planes, semantics.labels, cells);
  }
}

Summary summary_of(const LineLog& log, const sim::Tour& tour, const Modeler& modeler) {
  Summary summary;
  summary.lines = log.line_s.size();
  summary.dropped_lines = log.dropped;
  summary.ribbons = modeler.statistics().ribbons;
  summary.us_per_line = 1e6 * quantile(log.line_s, 0.5);
  summary.real_time_factor = to_seconds(tour.duration()) / log.total_s;
  return summary;
}

void add_ribbon_errors(const PointTruth& truth, const Modeler& modeler, Summary& summary) {
  if (const auto errors = truth.ribbon_errors(modeler)) {
    summary.ribbon_angle_deg = errors->angle_deg;
    summary.ribbon_distance_m = errors->distance_m;
  }
}

}  // namespace

Results run_experiment(const sim::World& world, const sim::Route& route,
                       const sim::TourConfig& tour_config, const ModelerConfig& modeler_config,
                       Closure closure, const ProgressCallback& progress) {
  sim::Tour tour(world, route, tour_config);
  Modeler modeler(modeler_config);
  Truth truth(world);
  std::optional<SelfClosure> self;
  if (closure != Closure::truth)
    self.emplace(modeler, modeler_config, closure == Closure::self_with_base_laser);
  const LineLog log = drive(tour, modeler, self ? &*self : nullptr, truth, progress);

  Results results;
  results.surface = modeler_config.surface;
  results.summary = summary_of(log, tour, modeler);
  const std::vector<sim::TruthPlane> true_planes = truth.collector.planes();
  truth.points.settle(true_planes);
  results.truth = patches_of(true_planes);
  results.world_outlines = world_outlines(world);
  results.models.noisy_as_built = modeler.planes_as_built();
  results.models.noisy = modeler.planes();
  results.trajectory_before = modeler.trajectory();
  results.trajectory_truth = true_poses(tour, modeler.trajectory());

  const std::vector<StampedPose> corrected = self ? self->finish(tour) : results.trajectory_truth;
  if (self) {
    results.summary.estimate = self->summary(corrected, tour);
    results.covariances_after = self->covariances();
    results.trajectory_live = self->live_trajectory();
  }
  results.summary.correction_ms = 1e3 * wall_seconds_of([&] { modeler.correct(corrected); });
  results.models.corrected_as_built = modeler.planes_as_built();
  results.models.corrected = modeler.planes();
  results.trajectory_after = modeler.trajectory();
  evaluate_planes(results, world, truth);
  results.summary.points = for_each_model(results.models, [&](const std::vector<Plane>& planes) {
    return point_metrics(truth.points, modeler, planes);
  });
  add_ribbon_errors(truth.points, modeler, results.summary);
  return results;
}

}  // namespace ribbon_mapper::eval
