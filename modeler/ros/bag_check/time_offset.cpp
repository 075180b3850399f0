// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/time_offset.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/io/config_file.hpp"
#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_timing/swept_lines.hpp"
#include "modeler/ros/bag_timing/time_increment.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kStep_s = 0.01;
constexpr int kFineSteps = 4;  // in each direction
constexpr std::size_t kMinLines = 20;
/// A smaller estimate may come from noise alone.
constexpr double kMinOffset_s = 0.002;
constexpr double kClearlyThinner = 0.97;
/// Voxels occupied with the right offset, per voxels occupied with a typical wrong one. Noise of the
/// count itself is below one per cent.
constexpr double kClearlyFewer = 0.97;
/// Minima further apart than this are different answers.
constexpr double kApart_s = 0.1;
/// A second minimum is as good as the best one if it lacks less than this part of the depth.
constexpr double kAsGood = 0.2;

/// The number of occupied voxels for each offset.
struct SearchCurve {
  std::vector<double> offsets_s, voxels;
};

SearchCurve search(const SweptLines& lines, double time_increment_s) {
  SearchCurve curve;
  const int steps = static_cast<int>(lines.max_offset_s() / kStep_s);
  for (int step = -steps; step <= steps; ++step) {
    curve.offsets_s.push_back(step * kStep_s);
    curve.voxels.push_back(static_cast<double>(
        lines.occupied_voxels({curve.offsets_s.back(), time_increment_s})));
  }
  return curve;
}

/// Returns the offset of the only clear minimum; nothing if there is none.
std::optional<double> only_minimum_s(const SearchCurve& curve) {
  const std::vector<double>& voxels = curve.voxels;
  if (voxels.size() < 3) return std::nullopt;
  const auto best = std::min_element(voxels.begin(), voxels.end());
  if (best == voxels.begin() || best == voxels.end() - 1) return std::nullopt;
  std::vector<double> sorted = voxels;
  std::sort(sorted.begin(), sorted.end());
  const double typical = sorted[sorted.size() / 2];
  if (*best > kClearlyFewer * typical) return std::nullopt;
  const double best_s = curve.offsets_s[static_cast<std::size_t>(best - voxels.begin())];
  for (std::size_t i = 1; i + 1 < voxels.size(); ++i) {
    const bool is_minimum = voxels[i] <= voxels[i - 1] && voxels[i] <= voxels[i + 1];
    const bool is_as_good = voxels[i] - *best < kAsGood * (typical - *best);
    if (is_minimum && is_as_good && std::abs(curve.offsets_s[i] - best_s) > kApart_s) {
      return std::nullopt;
    }
  }
  return best_s;
}

/// Returns the offset near `about_s` that makes the thinnest planes.
std::optional<TimeOffset> thinnest(const SweptLines& lines, const ModelerConfig& config,
                                   double about_s, double time_increment_s) {
  std::vector<double> thickness;
  for (int step = -kFineSteps; step <= kFineSteps; ++step) {
    const auto at = lines.thickness_m({about_s + step * kStep_s, time_increment_s}, config);
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
  const double steps = static_cast<double>(best - thickness.begin()) - kFineSteps + shift;
  return TimeOffset{about_s + steps * kStep_s, *best, 0.0, std::nullopt};
}

/// Returns the best offset with the recorded time increment, or with the one that fits the period of
/// the lines if the recorded one does not and planes become clearly thinner.
std::optional<TimeOffset> best_of(const SweptLines& lines, const ModelerConfig& config,
                                  double about_s) {
  const LaserBeams& beams = lines.first_beams();
  const double recorded_s = beams.time_increment_s;
  std::optional<TimeOffset> best = thinnest(lines, config, about_s, recorded_s);
  if (fits_period(recorded_s, beams, lines.period_s())) return best;
  const double fitting_s = time_increment_of(lines.period_s(), beams.angle_increment_rad);
  const double half_line_s =
      0.5 * (fitting_s - recorded_s) * static_cast<double>(beams.ranges_m.size() - 1);
  auto other = thinnest(lines, config, about_s - half_line_s, fitting_s);
  if (!other || (best && other->thickness_m > kClearlyThinner * best->thickness_m)) return best;
  other->time_increment_s = fitting_s;
  return other;
}

}  // namespace

std::optional<TimeOffset> estimate_time_offset(const std::vector<std::filesystem::path>& bags,
                                               const BagOptions& options,
                                               const ModelerConfig& config) {
  const SweptLines lines(bags, options, config.scan);
  if (lines.size() < kMinLines) return std::nullopt;
  const double recorded_s = lines.first_beams().time_increment_s;
  const auto about_s = only_minimum_s(search(lines, recorded_s));
  if (!about_s) return std::nullopt;
  auto found = best_of(lines, config, *about_s);
  if (!found) return std::nullopt;
  const auto now_m = lines.thickness_m({0.0, recorded_s}, config);
  found->thickness_now_m = now_m.value_or(0.0);
  return found;
}

void report_time_offset(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                        const std::string& preset, BagReport& report) {
  const auto found = estimate_time_offset(bags, options, load_config(preset));
  if (!found) {
    report.fact("the motion does not show whether the laser's stamps are off: up and down sweeps of "
                "the tilt are needed");
    return;
  }
  const std::string planes = " would make planes " + number(1e3 * found->thickness_m, 1) +
                             " mm thick instead of " + number(1e3 * found->thickness_now_m, 1) +
                             " mm";
  if (found->time_increment_s) {
    report.warning("time_increment is wrong, by up and down sweeps: " +
                   number(1e6 * *found->time_increment_s, 2) + " us" + planes +
                   ": correct the driver");
  }
  if (std::abs(found->offset_s) < kMinOffset_s ||
      (!found->time_increment_s && std::abs(found->offset_s) < kApart_s &&
       found->thickness_m > kClearlyThinner * found->thickness_now_m)) {
    report.fact(
        "up and down sweeps agree: no time offset of the laser makes planes clearly thinner");
    return;
  }
  const std::string total = number(options.intake.scan_time_offset_s + found->offset_s, 3);
  report.warning("up and down sweeps do not agree: scan_time_offset " + total +
                 (found->time_increment_s ? " is needed as well" : planes) +
                 " (--scan-time-offset " + total + ")");
}

}  // namespace ribbon_mapper
