// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/segmentation/evops.hpp"

#include <algorithm>
#include <vector>

namespace ribbon_mapper::eval {
namespace {

constexpr double kWhole = 0.75, kPartial = 0.2;

/// Counts the matches of one region among those of the other segmentation.
struct Partners {
  std::size_t partial = 0, whole = 0;
  std::size_t last = 0;  ///< index of the latest partial match

  void add(double iou, std::size_t other) {
    if (iou >= kWhole) ++whole;
    if (iou < kPartial) return;
    ++partial;
    last = other;
  }
};

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

double segmented_share(const std::vector<Partners>& regions) {
  const auto several = std::count_if(regions.begin(), regions.end(),
                                     [](const Partners& p) { return p.partial > 1; });
  return share(static_cast<std::size_t>(several), regions.size());
}

double unpaired_share(const std::vector<Partners>& regions, const std::vector<Partners>& others) {
  const auto is_unpaired = [&](const Partners& p) {
    return p.partial == 0 || (p.partial == 1 && p.whole == 0 && others[p.last].partial == 1);
  };
  const auto unpaired = std::count_if(regions.begin(), regions.end(), is_unpaired);
  return share(static_cast<std::size_t>(unpaired), regions.size());
}

std::size_t greedy_matches(const Overlaps& overlaps) {
  std::vector<bool> used(overlaps.estimates(), false);
  std::size_t matched = 0;
  for (std::size_t t = 0; t < overlaps.truth(); ++t) {
    for (std::size_t e = 0; e < overlaps.estimates(); ++e) {
      if (used[e] || overlaps.iou(t, e) < kWhole) continue;
      used[e] = true;
      ++matched;
      break;
    }
  }
  return matched;
}

}  // namespace

Evops evops(const Overlaps& overlaps) {
  std::vector<Partners> truth(overlaps.truth()), estimates(overlaps.estimates());
  for (std::size_t t = 0; t < truth.size(); ++t) {
    for (std::size_t e = 0; e < estimates.size(); ++e) {
      const double iou = overlaps.iou(t, e);
      truth[t].add(iou, e);
      estimates[e].add(iou, t);
    }
  }
  Evops result;
  result.matched = greedy_matches(overlaps);
  result.precision = share(result.matched, estimates.size());
  result.recall = share(result.matched, truth.size());
  const double sum = result.precision + result.recall;
  if (sum > 0.0) result.f1 = 2.0 * result.precision * result.recall / sum;
  result.under_segmented = segmented_share(estimates);
  result.over_segmented = segmented_share(truth);
  result.noise = unpaired_share(estimates, truth);
  result.missed = unpaired_share(truth, estimates);
  return result;
}

}  // namespace ribbon_mapper::eval
