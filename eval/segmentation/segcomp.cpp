// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/segmentation/segcomp.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace ribbon_mapper::eval {
namespace {

/// Regions that could be classified together.
struct Instance {
  enum Class { correct, over, under } what;
  std::vector<std::size_t> truth, estimates;
  double score;  ///< mean of the two shares that exceed the tolerance
};

void add_correct(const Overlaps& o, double tolerance, std::vector<Instance>& instances) {
  for (std::size_t t = 0; t < o.truth(); ++t) {
    for (std::size_t e = 0; e < o.estimates(); ++e) {
      const double of_truth = o.share_of_truth(t, e), of_estimate = o.share_of_estimate(t, e);
      if (of_truth <= tolerance || of_estimate <= tolerance) continue;
      instances.push_back({Instance::correct, {t}, {e}, 0.5 * (of_truth + of_estimate)});
    }
  }
}

/// Collects the members that lie in a whole. Returns their score if there are several and they
/// cover the whole. `own(i)` is the share of member i that lies in the whole, `part(i)` the share
/// of the whole that lies in member i.
template <typename Own, typename Part>
std::optional<double> composition(std::size_t count, double tolerance, const Own& own,
                                  const Part& part, std::vector<std::size_t>& members) {
  double owns = 0.0, parts = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (own(i) <= tolerance) continue;
    members.push_back(i);
    owns += own(i);
    parts += part(i);
  }
  if (members.size() < 2 || parts <= tolerance) return std::nullopt;
  return 0.5 * (owns / static_cast<double>(members.size()) + parts);
}

void add_over(const Overlaps& o, double tolerance, std::vector<Instance>& instances) {
  for (std::size_t t = 0; t < o.truth(); ++t) {
    std::vector<std::size_t> pieces;
    const auto score = composition(
        o.estimates(), tolerance, [&](std::size_t e) { return o.share_of_estimate(t, e); },
        [&](std::size_t e) { return o.share_of_truth(t, e); }, pieces);
    if (score) instances.push_back({Instance::over, {t}, std::move(pieces), *score});
  }
}

void add_under(const Overlaps& o, double tolerance, std::vector<Instance>& instances) {
  for (std::size_t e = 0; e < o.estimates(); ++e) {
    std::vector<std::size_t> lumped;
    const auto score = composition(
        o.truth(), tolerance, [&](std::size_t t) { return o.share_of_truth(t, e); },
        [&](std::size_t t) { return o.share_of_estimate(t, e); }, lumped);
    if (score) instances.push_back({Instance::under, std::move(lumped), {e}, *score});
  }
}

/// Marks the regions as taken. Returns false and marks nothing if one of them is taken already.
bool take(const std::vector<std::size_t>& truth, const std::vector<std::size_t>& estimates,
          std::vector<bool>& truth_taken, std::vector<bool>& estimate_taken) {
  for (const std::size_t t : truth) {
    if (truth_taken[t]) return false;
  }
  for (const std::size_t e : estimates) {
    if (estimate_taken[e]) return false;
  }
  for (const std::size_t t : truth) truth_taken[t] = true;
  for (const std::size_t e : estimates) estimate_taken[e] = true;
  return true;
}

std::vector<std::size_t> rest_of(const std::vector<bool>& taken) {
  std::vector<std::size_t> rest;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (!taken[i]) rest.push_back(i);
  }
  return rest;
}

std::size_t all_points(const Overlaps& overlaps) {
  std::size_t points = 0;
  for (std::size_t t = 0; t < overlaps.truth(); ++t) points += overlaps.truth_points(t);
  return points;
}

}  // namespace

SegComp segcomp(const Overlaps& overlaps, double tolerance) {
  if (!(tolerance >= 0.5 && tolerance < 1.0)) {
    throw std::invalid_argument("segcomp: tolerance must be in 0.5..1");
  }
  std::vector<Instance> instances;  // in the order that breaks ties
  add_correct(overlaps, tolerance, instances);
  add_over(overlaps, tolerance, instances);
  add_under(overlaps, tolerance, instances);
  std::stable_sort(instances.begin(), instances.end(),
                   [](const Instance& a, const Instance& b) { return a.score > b.score; });

  SegComp result;
  result.truth = overlaps.truth();
  result.estimates = overlaps.estimates();
  std::vector<bool> truth_taken(result.truth, false), estimate_taken(result.estimates, false);
  std::size_t correct_points = 0;
  for (const Instance& instance : instances) {
    if (!take(instance.truth, instance.estimates, truth_taken, estimate_taken)) continue;
    result.over += instance.what == Instance::over ? 1 : 0;
    result.under += instance.what == Instance::under ? 1 : 0;
    if (instance.what != Instance::correct) continue;
    ++result.correct;
    correct_points += overlaps.truth_points(instance.truth.front());
  }
  result.missed = rest_of(truth_taken);
  result.noise = rest_of(estimate_taken);
  if (result.truth > 0) {
    result.correct_share = static_cast<double>(result.correct) / static_cast<double>(result.truth);
  }
  if (const std::size_t points = all_points(overlaps)) {
    result.correct_points_share = static_cast<double>(correct_points) / static_cast<double>(points);
  }
  return result;
}

}  // namespace ribbon_mapper::eval
