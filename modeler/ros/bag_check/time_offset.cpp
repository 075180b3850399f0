// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/time_offset.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/io/config_file.hpp"
#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_timing/swept_lines.hpp"
#include "modeler/ros/messages/time_increment.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kStep_s = 0.01;
constexpr int kFineSteps = 4;  // in each direction
constexpr std::size_t kMinLines = 20;
/// A smaller estimate may come from noise alone.
constexpr double kMinOffset_s = 0.002;
constexpr double kClearlyThinner = 0.97;
/// Voxels occupied with the right offset, per voxels occupied with a typical wrong one. In
/// recordings with up and down sweeps, the ratio is 0.54 to 0.67; where the laser turns one way,
/// above 0.96.
constexpr double kClearlyFewer = 0.85;
/// Minima further apart than this are different answers.
constexpr double kApart_s = 0.1;
constexpr double kFarApart_s = 0.3;
/// More answers than this are none: the laser turns step by step.
constexpr std::size_t kMaxAnswers = 3;
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
    curve.voxels.push_back(
        static_cast<double>(lines.occupied_voxels({curve.offsets_s.back(), time_increment_s})));
  }
  return curve;
}

/// Returns the offsets with the fewest voxels, the best one first; none if no offset is clearly
/// better than a typical wrong one. A laser that tilts up and down at the same speed makes the
/// mirror image of a room when its stamps are off by half a period.
std::vector<double> fitting_offsets_s(const SearchCurve& curve) {
  const std::vector<double>& voxels = curve.voxels;
  if (voxels.size() < 3) return {};
  std::vector<double> sorted = voxels;
  std::sort(sorted.begin(), sorted.end());
  const double fewest = sorted.front(), typical = sorted[sorted.size() / 2];
  if (fewest > kClearlyFewer * typical) return {};
  std::vector<std::size_t> minima;
  for (std::size_t i = 1; i + 1 < voxels.size(); ++i) {
    const bool is_minimum = voxels[i] <= voxels[i - 1] && voxels[i] <= voxels[i + 1];
    const bool is_as_good = voxels[i] - fewest < kAsGood * (typical - fewest);
    if (is_minimum && is_as_good) minima.push_back(i);
  }
  std::sort(minima.begin(), minima.end(),
            [&](std::size_t a, std::size_t b) { return voxels[a] < voxels[b]; });
  std::vector<double> fitting_s;
  for (const std::size_t i : minima) {
    const double offset_s = curve.offsets_s[i];
    const bool is_new = std::none_of(fitting_s.begin(), fitting_s.end(), [&](double other_s) {
      return std::abs(other_s - offset_s) < kApart_s;
    });
    if (is_new) fitting_s.push_back(offset_s);
  }
  return fitting_s;
}

/// Returns the only offset that fits. Of a few, only one that is near 0 and far from the others can
/// be meant. There are many where the laser turns step by step.
std::optional<double> choice_of(const std::vector<double>& fitting_s) {
  const auto is_meant = [&](double offset_s) {
    return std::abs(offset_s) < kApart_s &&
           std::all_of(fitting_s.begin(), fitting_s.end(), [&](double other_s) {
             return other_s == offset_s || std::abs(other_s - offset_s) > kFarApart_s;
           });
  };
  if (fitting_s.size() == 1) return fitting_s.front();
  const auto meant = std::find_if(fitting_s.begin(), fitting_s.end(), is_meant);
  if (meant == fitting_s.end()) return std::nullopt;
  return *meant;
}

/// Returns the offset near `about_s` that makes the thinnest planes.
std::optional<TimeOffset> thinnest(const SweptLines& lines, const ModelerConfig& config,
                                   double about_s, double time_increment_s) {
  std::vector<double> thickness;
  for (int step = -kFineSteps; step <= kFineSteps; ++step) {
    const auto at = lines.thickness({about_s + step * kStep_s, time_increment_s}, config).rms_m();
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
  const double offset_s = about_s + steps * kStep_s;
  const auto there_m = lines.thickness({offset_s, time_increment_s}, config).rms_m();
  TimeOffset found;
  found.offset_s = offset_s;
  found.thickness_m = std::min(*best, there_m.value_or(*best));
  return found;
}

/// Returns the best offset with the recorded time increment, or with the one that fits the period
/// of the lines.
std::optional<TimeOffset> best_of(const SweptLines& lines, const ModelerConfig& config,
                                  double about_s) {
  const LaserBeams& beams = lines.first_beams();
  const double recorded_s = beams.time_increment_s;
  std::optional<TimeOffset> best = thinnest(lines, config, about_s, recorded_s);
  const bool is_unknown = recorded_s == 0.0;
  const bool is_possible = is_unknown || leaves_turns_out(beams, lines.period_s());
  if (!is_unknown && fits_period(recorded_s, beams, lines.period_s())) return best;
  const double fitting_s = time_increment_of(lines.period_s(), beams.angle_increment_rad);
  const double half_line_s =
      0.5 * (fitting_s - recorded_s) * static_cast<double>(beams.ranges_m.size() - 1);
  auto other = thinnest(lines, config, about_s - half_line_s, fitting_s);
  if (!other) return best;
  // What cannot be has to prove itself; otherwise the guess has.
  const double ratio = best ? other->thickness_m / best->thickness_m : 0.0;
  if (ratio > (is_possible ? kClearlyThinner : 1.0 / kClearlyThinner)) return best;
  other->time_increment_s = fitting_s;
  return other;
}

/// Compares the planes with the offset with those without it.
void compare_with_now(const SweptLines& lines, const ModelerConfig& config, TimeOffset& found) {
  const double recorded_s = lines.first_beams().time_increment_s;
  const PlaneThickness now = lines.thickness({0.0, recorded_s}, config);
  const PlaneThickness there =
      lines.thickness({found.offset_s, found.time_increment_s.value_or(recorded_s)}, config);
  found.thickness_now_m = now.rms_m().value_or(0.0);
  found.is_clear =
      found.thickness_m < kClearlyThinner * found.thickness_now_m && there.is_thinner_than(now);
}

/// The answer of a recording.
struct Answer {
  std::vector<double> fitting_s;  ///< see fitting_offsets_s()
  std::optional<TimeOffset> offset;
};

Answer ask(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
           const ModelerConfig& config) {
  const SweptLines lines(bags, options, config.scan);
  if (lines.size() < kMinLines) return {};
  const double recorded_s = lines.first_beams().time_increment_s;
  Answer answer{fitting_offsets_s(search(lines, recorded_s)), std::nullopt};
  const auto about_s = choice_of(answer.fitting_s);
  if (!about_s) return answer;
  answer.offset = best_of(lines, config, *about_s);
  if (answer.offset) {
    compare_with_now(lines, config, *answer.offset);
  }
  return answer;
}

void report_offset(const TimeOffset& found, double given_s, BagReport& report) {
  const std::string planes = " would make planes " + number(1e3 * found.thickness_m, 1) +
                             " mm thick instead of " + number(1e3 * found.thickness_now_m, 1) +
                             " mm";
  if (found.time_increment_s && found.is_clear) {
    report.warning("time_increment is wrong, by up and down sweeps: " +
                   number(1e6 * *found.time_increment_s, 2) + " us" + planes +
                   ": correct the driver");
  }
  const bool is_small = std::abs(found.offset_s) < kMinOffset_s;
  const bool has_no_effect = std::abs(found.offset_s) < kApart_s && !found.is_clear;
  if (is_small || has_no_effect) {
    report.fact(
        "up and down sweeps agree: no time offset of the laser makes planes clearly thinner");
    return;
  }
  const double total_s = std::round(1e3 * (given_s + found.offset_s)) / 1e3 + 0.0;  // no -0
  const std::string total = number(total_s, 3);
  report.warning(
      "up and down sweeps do not agree: scan_time_offset " + total +
      (found.time_increment_s ? " is needed as well" : planes) +
      (total_s == 0.0 ? " (leave out --scan-time-offset)" : " (--scan-time-offset " + total + ")"));
}

}  // namespace

std::optional<TimeOffset> estimate_time_offset(const std::vector<std::filesystem::path>& bags,
                                               const BagOptions& options,
                                               const ModelerConfig& config) {
  return ask(bags, options, config).offset;
}

void report_time_offset(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                        const std::string& preset, BagReport& report) {
  const Answer answer = ask(bags, options, load_config(preset));
  const double given_s = options.intake.scan_time_offset_s;
  if (answer.offset) return report_offset(*answer.offset, given_s, report);
  if (answer.fitting_s.size() < 2 || answer.fitting_s.size() > kMaxAnswers) {
    report.fact(
        "the motion does not show whether the laser's stamps are off: up and down sweeps of the "
        "tilt "
        "are needed");
    return;
  }
  std::string list;
  for (const double offset_s : answer.fitting_s) {
    list += (list.empty() ? "" : ", ") + number(given_s + offset_s, 2);
  }
  report.warning(
      "up and down sweeps do not agree, but the motion fits several values of "
      "scan_time_offset: " +
      list + ". Record tilts of another period, or a moving robot");
}

}  // namespace ribbon_mapper
