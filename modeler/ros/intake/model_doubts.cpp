// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/model_doubts.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

namespace ribbon_mapper {
namespace {

constexpr std::size_t kFewLines = 10;

using Counts = std::map<std::string, std::size_t>;

std::string listed(const Counts& counts) {
  std::string text;
  for (const auto& [what, count] : counts) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " x " + what;
  }
  return text;
}

/// Returns what to do about the outcome of most lines.
std::string advice_on(const Counts& outcomes) {
  const auto most =
      std::max_element(outcomes.begin(), outcomes.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most->first == to_string(LineResult::no_returns)) {
    return "no range lies within the laser's limits and scan.min_range_m .. scan.max_range_m";
  }
  if (most->first == to_string(LineResult::too_close)) {
    return "the laser hardly moves from line to line: does it tilt, and does tf show that? Lines "
           "closer than the noise need a smaller scan.line_step_sigmas";
  }
  if (most->first == to_string(LineResult::waiting)) {
    return "no line has neighbours at the same bearings on both sides: does the laser move, and do "
           "lines turn the same way round?";
  }
  return "surfaces are too short, too far apart or too noisy for ribbon.min_length_m, "
         "ribbon.min_points, ribbon.neighbourhood_m and scan.range_sigma_m: `bag_check "
         "--propose-preset FILE` writes a preset for the laser";
}

/// Returns what has come to the counts; all of them if one has become less: they began anew.
Counts added_to(const Counts& before, const Counts& now) {
  Counts added = now;
  for (const auto& [what, count] : before) {
    const auto found = added.find(what);
    if (found == added.end() || found->second < count) return now;
    if ((found->second -= count) == 0) added.erase(found);
  }
  return added;
}

}  // namespace

std::string no_return_text(const NoReturnRange& no_return) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%.1f %% of the ranges have one value, %.4g m to the bit: the driver reports no "
                "return as a distance. They count as no return",
                100.0 * no_return.share, static_cast<double>(no_return.range_m));
  return text;
}

std::string why_no_ribbons(const LineLog& log) {
  if (log.lines() == 0) return "there is no scan";
  const Counts &outcomes = log.handled_by_outcome(), &drops = log.dropped_by_reason();
  if (outcomes.count(to_string(LineResult::modelled)) > 0) return "";
  if (outcomes.empty()) return "no line can be used: " + listed(drops);
  return "no line gives a ribbon (" + listed(outcomes) +
         (drops.empty() ? "" : "; dropped: " + listed(drops)) + "): " + advice_on(outcomes);
}

std::string why_no_planes(const LineLog& log, const ModelStatistics& statistics,
                          const AssemblyConfig& config) {
  std::string why = why_no_ribbons(log);
  if (!why.empty()) return why;
  char text[256];
  std::snprintf(text, sizeof text,
                "%zu ribbons, but they make no plane of assembly.min_ribbons (%d) ribbons and "
                "assembly.min_area_m2 (%.3g m2): is the recording long enough, and are the poses "
                "right?",
                statistics.ribbons, config.min_ribbons, config.min_area_m2);
  return text;
}

std::string BarrenLines::complaint(const LineLog& log) {
  Counts counts = log.handled_by_outcome();
  // A laser at rest is no fault once there is a model.
  if (counts.count(to_string(LineResult::modelled)) > 0)
    counts.erase(to_string(LineResult::too_close));
  const Counts added = added_to(std::exchange(before_, counts), counts);
  std::size_t lines = 0;
  for (const auto& [outcome, count] : added) lines += count;
  if (added.count(to_string(LineResult::modelled)) > 0 || lines < kFewLines) return "";
  return std::to_string(lines) + " lines are taken, but none gives a ribbon (" + listed(added) +
         "): " + advice_on(added);
}

}  // namespace ribbon_mapper
