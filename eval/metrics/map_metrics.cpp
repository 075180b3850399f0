// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/map_metrics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "eval/metrics/cell_index.hpp"
#include "eval/metrics/statistics.hpp"
#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper::eval {
namespace {

/// A candidate match of an estimate with a true plane.
struct Pair {
  std::size_t estimate = 0;
  std::size_t truth = 0;
  double angle_deg = 0.0;
  double offset_m = 0.0;
  std::size_t shared_truth_cells = 0;
};

double angle_between_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return to_degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

/// Projects the cells of a patch into the 2D frame of the plane with this normal.
std::vector<Eigen::Vector2d> projected(const Patch& patch, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  std::vector<Eigen::Vector2d> points;
  points.reserve(patch.cells.size());
  for (const Eigen::Vector3d& cell : patch.cells) points.emplace_back(cell.dot(u), cell.dot(v));
  return points;
}

/// A true plane with the index for comparing it with many estimates.
class TrueSurface {
 public:
  TrueSurface(const Patch& patch, const MatchLimits& limits)
      : patch_(patch),
        limits_(limits),
        points_(projected(patch, patch.normal)),
        index_(points_, limits.reach_m),
        seen_(points_.size(), false) {}

  /// Adds the cells that the estimate has seen to the coverage. Fills in `pair` and returns true if
  /// the two overlap enough to match.
  bool compare(const Patch& estimate, Pair& pair) {
    pair.angle_deg = angle_between_deg(estimate.normal, patch_.normal);
    pair.offset_m = std::abs(patch_.normal.dot(centroid_of(estimate)) + patch_.d_m);
    if (pair.angle_deg >= limits_.max_angle_deg || pair.offset_m >= limits_.max_offset_m) {
      return false;
    }
    const auto cells = projected(estimate, patch_.normal);
    const auto shared_estimate_cells = std::count_if(
        cells.begin(), cells.end(), [&](const auto& cell) { return index_.has_near(cell); });
    if (shared_estimate_cells == 0) return false;
    pair.shared_truth_cells = mark_seen(CellIndex(cells, limits_.reach_m));
    return share(shared_estimate_cells, cells.size()) >= limits_.min_overlap ||
           share(pair.shared_truth_cells, points_.size()) >= limits_.min_overlap;
  }

  double coverage() const {
    return share(std::count(seen_.begin(), seen_.end(), true), seen_.size());
  }

 private:
  template <typename Count>
  static double share(Count part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  }

  /// Marks the true cells that the estimate has seen and returns their number.
  std::size_t mark_seen(const CellIndex& estimate) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!estimate.has_near(points_[i])) continue;
      seen_[i] = true;
      ++count;
    }
    return count;
  }

  const Patch& patch_;
  const MatchLimits& limits_;
  std::vector<Eigen::Vector2d> points_;
  CellIndex index_;
  std::vector<bool> seen_;
};

/// Returns all candidate matches and stores the coverage by all estimates within the limits.
std::vector<Pair> candidate_pairs(const std::vector<Patch>& estimates,
                                  const std::vector<Patch>& truth, const MatchLimits& limits,
                                  double& coverage) {
  std::vector<Pair> pairs;
  double area_m2 = 0.0, covered_m2 = 0.0;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    TrueSurface surface(truth[t], limits);
    for (std::size_t e = 0; e < estimates.size(); ++e) {
      Pair pair{e, t, 0.0, 0.0, 0};
      if (surface.compare(estimates[e], pair)) pairs.push_back(pair);
    }
    area_m2 += truth[t].area_m2;
    covered_m2 += truth[t].area_m2 * surface.coverage();
  }
  coverage = area_m2 > 0.0 ? covered_m2 / area_m2 : 0.0;
  return pairs;
}

bool goes_first(const Pair& a, const Pair& b) {
  return std::make_tuple(b.shared_truth_cells, a.offset_m, a.estimate, a.truth) <
         std::make_tuple(a.shared_truth_cells, b.offset_m, b.estimate, b.truth);
}

void set_errors(const std::vector<Pair>& matches, MapMetrics& metrics) {
  if (matches.empty()) return;
  std::vector<double> angles_deg, offsets_m;
  for (const Pair& match : matches) {
    angles_deg.push_back(match.angle_deg);
    offsets_m.push_back(match.offset_m);
  }
  metrics.angle_error_deg_mean = mean_of(angles_deg);
  metrics.angle_error_deg_median = quantile(angles_deg, 0.5);
  metrics.offset_error_m_mean = mean_of(offsets_m);
  metrics.offset_error_m_median = quantile(offsets_m, 0.5);
  metrics.duplication_ratio =
      1.0 + static_cast<double>(metrics.duplicates.size()) / static_cast<double>(matches.size());
}

void set_ratios(MapMetrics& metrics) {
  const auto matched = static_cast<double>(metrics.matched);
  if (metrics.planes > 0) metrics.precision = matched / static_cast<double>(metrics.planes);
  if (metrics.truth > 0) metrics.recall = matched / static_cast<double>(metrics.truth);
  const double sum = metrics.precision + metrics.recall;
  if (sum > 0.0) metrics.f1 = 2.0 * metrics.precision * metrics.recall / sum;
}

}  // namespace

MapMetrics compare_maps(const std::vector<Patch>& estimates, const std::vector<Patch>& truth,
                        const MatchLimits& limits) {
  MapMetrics metrics;
  metrics.planes = estimates.size();
  metrics.truth = truth.size();
  std::vector<Pair> pairs = candidate_pairs(estimates, truth, limits, metrics.coverage);
  std::sort(pairs.begin(), pairs.end(), goes_first);

  std::vector<bool> is_candidate(estimates.size(), false), has_partner(estimates.size(), false);
  std::vector<bool> is_found(truth.size(), false);
  std::vector<Pair> matches;
  for (const Pair& pair : pairs) {
    is_candidate[pair.estimate] = true;
    if (has_partner[pair.estimate] || is_found[pair.truth]) continue;
    has_partner[pair.estimate] = is_found[pair.truth] = true;
    matches.push_back(pair);
  }
  metrics.matched = matches.size();
  for (const Pair& pair : matches) metrics.matches.push_back({pair.estimate, pair.truth});
  for (std::size_t t = 0; t < truth.size(); ++t) {
    if (!is_found[t]) metrics.missed.push_back(t);
  }
  for (std::size_t e = 0; e < estimates.size(); ++e) {
    if (!has_partner[e]) (is_candidate[e] ? metrics.duplicates : metrics.extra).push_back(e);
  }
  set_errors(matches, metrics);
  set_ratios(metrics);
  return metrics;
}

}  // namespace ribbon_mapper::eval
