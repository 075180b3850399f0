// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/no_return_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::size_t kMaxCandidates = 16;
constexpr std::size_t kMinRun = 5;  // neighbouring beams; fewer make hardly a ribbon
constexpr double kNear_m = 0.1;
constexpr std::size_t kMinLines = 3, kMinBeams = 100;
constexpr double kFew = 0.05;       // returns further away, per beam that has the range
constexpr double kFrequent = 0.01;  // share of all beams so far

}  // namespace

const LaserBeams& NoReturnFilter::filter(const LaserBeams& beams) {
  evidence_.beams += beams.ranges_m.size();
  if (const auto range_m = repeated_range(beams)) weigh(*range_m, beams);
  const LaserBeams* result = &beams;
  for (Candidate& candidate : evidence_.candidates) {
    if (!candidate.is_no_return) continue;
    if (result == &beams) filtered_ = beams;
    result = &filtered_;
    remove(candidate, beams);
  }
  return *result;
}

/// Returns the range of the longest run of neighbouring beams with equal ranges, if it is long
/// enough.
std::optional<float> NoReturnFilter::repeated_range(const LaserBeams& beams) const {
  const std::vector<float>& r = beams.ranges_m;
  std::size_t longest = kMinRun - 1;
  std::optional<float> range_m;
  for (std::size_t i = 0; i + 1 < r.size();) {
    if (r[i] != r[i + 1]) {
      i += kMinRun - 1;  // a run that is long enough has two neighbours at one of these places
      continue;
    }
    std::size_t begin = i, end = i + 2;
    while (begin > 0 && r[begin - 1] == r[i]) --begin;
    while (end < r.size() && r[end] == r[i]) ++end;
    if (end - begin > longest && is_return(r[i], beams, config_)) {
      longest = end - begin, range_m = r[i];
    }
    i = end;
  }
  return range_m;
}

/// Adds the evidence of a line, and decides.
void NoReturnFilter::weigh(float range_m, const LaserBeams& beams) {
  Candidate& it = candidate(range_m);
  if (it.is_no_return) return;
  ++it.lines;
  for (const float other_m : beams.ranges_m) {
    if (other_m == range_m)
      ++it.equal;
    else if (std::abs(other_m - range_m) < kNear_m)
      ++it.near;
    if (other_m > range_m && is_return(other_m, beams, config_)) ++it.beyond;
  }
  const bool is_at_the_end = range_m == static_cast<float>(beams.range_max_m);
  const bool is_repeated = it.lines >= kMinLines && it.equal >= kMinBeams;
  const auto equal = static_cast<double>(it.equal);
  const bool is_beyond_others = static_cast<double>(it.beyond) < kFew * equal;
  const bool is_frequent = equal > kFrequent * static_cast<double>(evidence_.beams);
  it.is_no_return = 2 * it.near < it.equal &&
                    (is_at_the_end || (is_repeated && (is_beyond_others || is_frequent)));
}

NoReturnFilter::Candidate& NoReturnFilter::candidate(float range_m) {
  for (Candidate& known : evidence_.candidates) {
    if (known.range_m == range_m) return known;
  }
  if (evidence_.candidates.size() < kMaxCandidates) {
    return evidence_.candidates.emplace_back(Candidate{range_m, 0, 0, 0, 0, 0, false});
  }
  Candidate& least = *std::min_element(
      evidence_.candidates.begin(), evidence_.candidates.end(),
      [](const Candidate& a, const Candidate& b) {
        return a.is_no_return != b.is_no_return ? b.is_no_return : a.equal < b.equal;
      });
  return least = {range_m, 0, 0, 0, 0, 0, false};
}

void NoReturnFilter::remove(Candidate& no_return, const LaserBeams& beams) {
  for (std::size_t i = 0; i < beams.ranges_m.size(); ++i) {
    if (beams.ranges_m[i] != no_return.range_m) continue;
    filtered_.ranges_m[i] = std::numeric_limits<float>::infinity();
    ++no_return.removed;
  }
}

std::optional<NoReturnRange> NoReturnFilter::found() const {
  std::optional<NoReturnRange> most;
  for (const Candidate& candidate : evidence_.candidates) {
    if (!candidate.is_no_return || (most && candidate.removed <= most->beams)) continue;
    const double share =
        static_cast<double>(candidate.removed) / static_cast<double>(evidence_.beams);
    most = NoReturnRange{candidate.range_m, candidate.removed, share};
  }
  return most;
}

}  // namespace ribbon_mapper
