// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/eval/segmentation/slow_segmentation.hpp"

#include <algorithm>

namespace ribbon_mapper::eval {
namespace {

double common(const Region& a, const Region& b) {
  double count = 0.0;
  for (const int point : a) count += static_cast<double>(b.count(point));
  return count;
}

double share_in(const Region& part, const Region& whole) {
  return part.empty() ? 0.0 : common(part, whole) / static_cast<double>(part.size());
}

double slow_iou(const Region& a, const Region& b) {
  Region both = a;
  both.insert(b.begin(), b.end());
  return both.empty() ? 0.0 : common(a, b) / static_cast<double>(both.size());
}

Region united(const Regions& regions) {
  Region all;
  for (const Region& region : regions) all.insert(region.begin(), region.end());
  return all;
}

/// A possible classification of regions.
struct Claim {
  std::string name;
  std::set<int> truth, estimates;
  double score = 0.0;
};

std::vector<Claim> correct_claims(const Regions& truth, const Regions& estimates,
                                  double tolerance) {
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < estimates.size(); ++j) {
      const double a = share_in(truth[i], estimates[j]), b = share_in(estimates[j], truth[i]);
      if (a <= tolerance || b <= tolerance) continue;
      claims.push_back({"correct", {static_cast<int>(i)}, {static_cast<int>(j)}, (a + b) / 2});
    }
  }
  return claims;
}

/// Stores the indices of the regions that lie in `whole`. Returns the score of the claim that they
/// make up the whole, or 0 if they do not.
double score_of_parts(const Region& whole, const Regions& regions, double tolerance,
                      std::set<int>& indices) {
  Regions parts;
  double inside = 0.0;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    if (share_in(regions[k], whole) <= tolerance) continue;
    indices.insert(static_cast<int>(k));
    parts.push_back(regions[k]);
    inside += share_in(regions[k], whole);
  }
  const double covered = share_in(whole, united(parts));
  if (parts.size() < 2 || covered <= tolerance) return 0.0;
  return (inside / static_cast<double>(parts.size()) + covered) / 2;
}

std::vector<Claim> claims_of(const Regions& truth, const Regions& estimates, double tolerance) {
  std::vector<Claim> claims = correct_claims(truth, estimates, tolerance);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    Claim claim{"over", {static_cast<int>(i)}, {}};
    claim.score = score_of_parts(truth[i], estimates, tolerance, claim.estimates);
    if (claim.score > 0.0) claims.push_back(claim);
  }
  for (std::size_t j = 0; j < estimates.size(); ++j) {
    Claim claim{"under", {}, {static_cast<int>(j)}};
    claim.score = score_of_parts(estimates[j], truth, tolerance, claim.truth);
    if (claim.score > 0.0) claims.push_back(claim);
  }
  return claims;
}

/// Returns the best claim whose regions are all unclassified, or nullptr.
const Claim* best_claim(const std::vector<Claim>& claims, const SlowSegComp& classes) {
  const Claim* best = nullptr;
  for (const Claim& claim : claims) {
    bool is_free = true;
    for (const int i : claim.truth) is_free &= classes.truth[i] == "missed";
    for (const int j : claim.estimates) is_free &= classes.estimates[j] == "noise";
    if (is_free && (!best || claim.score > best->score + 1e-12)) best = &claim;
  }
  return best;
}

Regions partners_of(const Region& region, const Regions& others, double min_iou) {
  Regions found;
  for (const Region& other : others) {
    if (slow_iou(region, other) >= min_iou) found.push_back(other);
  }
  return found;
}

bool is_segmented(const Region& region, const Regions& /*regions*/, const Regions& others) {
  return partners_of(region, others, 0.2).size() > 1;
}

bool is_unmatched(const Region& region, const Regions& regions, const Regions& others) {
  const Regions some = partners_of(region, others, 0.2);
  if (some.empty()) return true;
  return some.size() == 1 && partners_of(region, others, 0.75).empty() &&
         partners_of(some.front(), regions, 0.2).size() == 1;
}

/// Returns the share of regions for which the predicate holds.
template <typename Predicate>
double rate(const Regions& regions, const Regions& others, const Predicate& predicate) {
  const auto count = std::count_if(regions.begin(), regions.end(), [&](const Region& region) {
    return predicate(region, regions, others);
  });
  return regions.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(regions.size());
}

std::size_t matches(const Regions& truth, const Regions& estimates) {
  std::set<std::size_t> used;
  for (const Region& region : truth) {
    for (std::size_t j = 0; j < estimates.size(); ++j) {
      if (used.count(j) > 0 || slow_iou(region, estimates[j]) < 0.75) continue;
      used.insert(j);
      break;
    }
  }
  return used.size();
}

}  // namespace

SlowSegComp slow_segcomp(const Regions& truth, const Regions& estimates, double tolerance) {
  const std::vector<Claim> claims = claims_of(truth, estimates, tolerance);
  SlowSegComp result{std::vector<std::string>(truth.size(), "missed"),
                     std::vector<std::string>(estimates.size(), "noise")};
  while (const Claim* best = best_claim(claims, result)) {
    for (const int i : best->truth) result.truth[i] = best->name;
    for (const int j : best->estimates) result.estimates[j] = best->name;
  }
  return result;
}

Evops slow_evops(const Regions& truth, const Regions& estimates) {
  Evops result;
  result.matched = matches(truth, estimates);
  const auto matched = static_cast<double>(result.matched);
  if (!estimates.empty()) result.precision = matched / static_cast<double>(estimates.size());
  if (!truth.empty()) result.recall = matched / static_cast<double>(truth.size());
  if (matched > 0.0) result.f1 = 2.0 / (1.0 / result.precision + 1.0 / result.recall);
  result.under_segmented = rate(estimates, truth, is_segmented);
  result.over_segmented = rate(truth, estimates, is_segmented);
  result.noise = rate(estimates, truth, is_unmatched);
  result.missed = rate(truth, estimates, is_unmatched);
  return result;
}

}  // namespace ribbon_mapper::eval
