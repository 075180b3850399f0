// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/time_offset.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/io/config_file.hpp"
#include "modeler/modeler.hpp"
#include "modeler/ros/bag_check/number_text.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kMaxDuration_s = 30.0;
constexpr double kStep_s = 0.01;
constexpr int kSteps = 4;  // in each direction
/// A smaller estimate may come from noise alone.
constexpr double kMinOffset_s = 0.002;
constexpr double kClearlyThinner = 0.97;

std::vector<ReadyLine> first_lines(const std::vector<std::filesystem::path>& bags,
                                   const BagOptions& options) {
  LineLog log;
  BagLines source(bags, options, log);
  std::vector<ReadyLine> lines;
  while (std::optional<ReadyLine> line = source.next()) {
    if (!lines.empty() && to_seconds(line->beams.stamp - lines[0].beams.stamp) > kMaxDuration_s)
      break;
    lines.push_back(std::move(*line));
  }
  return lines;
}

/// Returns the root mean square distance of the points from their planes; nothing without planes.
std::optional<double> thickness_m(const std::vector<std::filesystem::path>& bags,
                                  BagOptions options, const ModelerConfig& config,
                                  double offset_s) {
  options.intake.scan_time_offset_s += offset_s;
  Modeler modeler(config);
  for (const ReadyLine& line : first_lines(bags, options)) {
    modeler.add_scan_line(line.beams, line.poses);
  }
  double points = 0.0, squares = 0.0;
  for (const Plane& plane : modeler.planes()) {
    for (const PlaneCell& cell : plane.cells) {
      points += cell.count;
      squares += cell.count * (cell.mean_m * cell.mean_m + cell.variance_m2);
    }
  }
  if (points == 0.0) return std::nullopt;
  return std::sqrt(squares / points);
}

}  // namespace

std::optional<TimeOffset> estimate_time_offset(const std::vector<std::filesystem::path>& bags,
                                               const BagOptions& options,
                                               const ModelerConfig& config) {
  std::vector<double> thickness;
  for (int step = -kSteps; step <= kSteps; ++step) {
    const auto at = thickness_m(bags, options, config, step * kStep_s);
    if (!at) return std::nullopt;
    thickness.push_back(*at);
  }
  const auto best = std::min_element(thickness.begin(), thickness.end());
  const auto thickest = std::max_element(thickness.begin(), thickness.end());
  if (*best > kClearlyThinner * *thickest) return std::nullopt;  // flat
  if (best == thickness.begin() || best == thickness.end() - 1) return std::nullopt;
  // The square of the thickness is a quadratic function of the offset.
  const auto square = [](double x) { return x * x; };
  const double left = square(best[-1]), middle = square(best[0]), right = square(best[1]);
  const double shift = 0.5 * (left - right) / (left - 2.0 * middle + right);
  const double steps = static_cast<double>(best - thickness.begin()) - kSteps + shift;
  return TimeOffset{steps * kStep_s, *best, thickness[kSteps]};
}

void report_time_offset(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                        const std::string& preset, BagReport& report) {
  const auto found = estimate_time_offset(bags, options, load_config(preset));
  if (!found) {
    report.fact("up and down sweeps do not show whether the laser's stamps are off");
    return;
  }
  const std::string total = number(options.intake.scan_time_offset_s + found->offset_s, 3);
  if (std::abs(found->offset_s) < kMinOffset_s ||
      found->thickness_m > kClearlyThinner * found->thickness_now_m) {
    report.fact(
        "up and down sweeps agree: no time offset of the laser makes planes clearly thinner");
    return;
  }
  report.warning("up and down sweeps do not agree: scan_time_offset " + total +
                 " would make planes " + number(1e3 * found->thickness_m, 1) +
                 " mm thick instead of " + number(1e3 * found->thickness_now_m, 1) + " mm");
}

}  // namespace ribbon_mapper
