// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "eval/metrics/evops.hpp"
#include "eval/metrics/segcomp.hpp"

namespace ribbon_mapper::eval {

/// Regions as sets of point indices: the definitions word by word, slowly, for comparison.
using Region = std::set<int>;
using Regions = std::vector<Region>;

inline double common(const Region& a, const Region& b) {
  double count = 0.0;
  for (const int point : a) count += static_cast<double>(b.count(point));
  return count;
}

inline double share_in(const Region& part, const Region& whole) {
  return part.empty() ? 0.0 : common(part, whole) / static_cast<double>(part.size());
}

inline double slow_iou(const Region& a, const Region& b) {
  Region both = a;
  both.insert(b.begin(), b.end());
  return both.empty() ? 0.0 : common(a, b) / static_cast<double>(both.size());
}

inline Region united(const Regions& regions) {
  Region all;
  for (const Region& region : regions) all.insert(region.begin(), region.end());
  return all;
}

/// Names of the classes that each true region and each estimate ended in.
struct SlowSegComp {
  std::vector<std::string> truth, estimates;
};

/// The best claim on regions that are all free is granted until there is none.
inline SlowSegComp slow_segcomp(const Regions& truth, const Regions& estimates, double tolerance) {
  struct Claim {
    std::string name;
    std::set<int> truth, estimates;
    double score;
  };
  std::vector<Claim> claims;
  const auto n = static_cast<int>(truth.size()), m = static_cast<int>(estimates.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = share_in(truth[i], estimates[j]), b = share_in(estimates[j], truth[i]);
      if (a > tolerance && b > tolerance) claims.push_back({"correct", {i}, {j}, (a + b) / 2});
    }
  for (int i = 0; i < n; ++i) {
    Claim claim{"over", {i}, {}, 0.0};
    Regions pieces;
    double inside = 0.0;
    for (int j = 0; j < m; ++j)
      if (share_in(estimates[j], truth[i]) > tolerance) {
        claim.estimates.insert(j);
        pieces.push_back(estimates[j]);
        inside += share_in(estimates[j], truth[i]);
      }
    const double covered = share_in(truth[i], united(pieces));
    if (pieces.size() < 2 || covered <= tolerance) continue;
    claim.score = (inside / static_cast<double>(pieces.size()) + covered) / 2;
    claims.push_back(claim);
  }
  for (int j = 0; j < m; ++j) {
    Claim claim{"under", {}, {j}, 0.0};
    Regions lumped;
    double inside = 0.0;
    for (int i = 0; i < n; ++i)
      if (share_in(truth[i], estimates[j]) > tolerance) {
        claim.truth.insert(i);
        lumped.push_back(truth[i]);
        inside += share_in(truth[i], estimates[j]);
      }
    const double covered = share_in(estimates[j], united(lumped));
    if (lumped.size() < 2 || covered <= tolerance) continue;
    claim.score = (inside / static_cast<double>(lumped.size()) + covered) / 2;
    claims.push_back(claim);
  }

  SlowSegComp result{std::vector<std::string>(truth.size(), "missed"),
                     std::vector<std::string>(estimates.size(), "noise")};
  for (;;) {
    const Claim* best = nullptr;
    for (const Claim& claim : claims) {
      bool is_free = true;
      for (const int i : claim.truth) is_free &= result.truth[i] == "missed";
      for (const int j : claim.estimates) is_free &= result.estimates[j] == "noise";
      if (is_free && (!best || claim.score > best->score + 1e-12)) best = &claim;
    }
    if (!best) return result;
    for (const int i : best->truth) result.truth[i] = best->name;
    for (const int j : best->estimates) result.estimates[j] = best->name;
  }
}

/// As prime-slam/evops-metrics describes its figures.
inline Evops slow_evops(const Regions& truth, const Regions& estimates) {
  Evops result;
  std::set<std::size_t> used;
  for (const Region& region : truth)
    for (std::size_t j = 0; j < estimates.size(); ++j)
      if (!used.count(j) && slow_iou(region, estimates[j]) >= 0.75) {
        used.insert(j);
        break;
      }
  const auto partners = [](const Region& region, const Regions& others, double least) {
    Regions found;
    for (const Region& other : others)
      if (slow_iou(region, other) >= least) found.push_back(other);
    return found;
  };
  const auto rate = [&](const Regions& regions, const Regions& others, bool segmented) {
    double count = 0.0;
    for (const Region& region : regions) {
      const Regions some = partners(region, others, 0.2);
      if (segmented) {
        count += some.size() > 1 ? 1.0 : 0.0;
      } else if (some.empty()) {
        count += 1.0;
      } else if (some.size() == 1 && partners(region, others, 0.75).empty()) {
        count += partners(some.front(), regions, 0.2).size() == 1 ? 1.0 : 0.0;
      }
    }
    return regions.empty() ? 0.0 : count / static_cast<double>(regions.size());
  };
  result.matched = used.size();
  const auto matched = static_cast<double>(used.size());
  if (!estimates.empty()) result.precision = matched / static_cast<double>(estimates.size());
  if (!truth.empty()) result.recall = matched / static_cast<double>(truth.size());
  if (matched > 0.0) {
    result.f1 = 2.0 / (1.0 / result.precision + 1.0 / result.recall);
  }
  result.under_segmented = rate(estimates, truth, true);
  result.over_segmented = rate(truth, estimates, true);
  result.noise = rate(estimates, truth, false);
  result.missed = rate(truth, estimates, false);
  return result;
}

}  // namespace ribbon_mapper::eval
