// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/seam.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "modeler/registration/odometry_noise.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kStrain_s = 1.0;  // a sweep shows walls again by then

/// Returns, for each line, the length of its ribbons that fit if moved, less what does not fit [m].
std::vector<double> gains(const PosedLines& lines, const LineRange& range,
                          const Pose& T_start_start, const KnownScene& scene,
                          const AssociationGates& gates) {
  std::vector<double> gains;
  for (std::uint32_t i = range.first; i < range.end; ++i) {
    const Agreement line = agreement_of(lines, {i, i + 1}, T_start_start, scene, gates);
    gains.push_back(2.0 * line.known_m - line.seen_m);
  }
  return gains;
}

/// How many of the first numbers have the largest sum: any number from `least` to `most`.
struct BestStart {
  std::uint32_t least = 0, most = 0;
};

template <typename Iterator>
BestStart best_start(Iterator first, Iterator last) {
  double sum = 0.0, largest = 0.0;
  std::uint32_t length = 0;
  BestStart best;
  for (; first != last; ++first) {
    sum += *first, ++length;
    if (sum > largest) largest = sum, best.least = length;
    if (sum == largest) best.most = length;
  }
  return best;
}

/// Returns the seam that parts best what fits where it is from what fits if moved.
Seam parting_of(const std::vector<double>& here, const std::vector<double>& moved,
                const LineRange& range) {
  std::vector<double> preference;
  for (std::size_t i = 0; i < here.size(); ++i) preference.push_back(here[i] - moved[i]);
  const BestStart split = best_start(preference.begin(), preference.end());
  return {range.first + split.least, range.first + split.most};
}

/// Returns a pose of which a part of a move was made.
Pose moved_in_part(const Pose& T_start_base, const Pose& T_start_start, double part) {
  const double yaw = std::atan2(T_start_start.linear()(1, 0), T_start_start.linear()(0, 0));
  Pose moved = T_start_base;
  moved.linear() = Eigen::AngleAxisd(part * yaw, Eigen::Vector3d::UnitZ()) * T_start_base.linear();
  moved.translation() +=
      part * (T_start_start * T_start_base.translation() - T_start_base.translation());
  return moved;
}

}  // namespace

Seam seam_of(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
             const KnownScene& scene, const AssociationGates& gates) {
  const std::vector<double> here = gains(lines, range, Pose::Identity(), scene, gates),
                            moved = gains(lines, range, T_start_start, scene, gates);
  const std::uint32_t stay = best_start(here.begin(), here.end()).least;
  const std::uint32_t move = best_start(moved.rbegin(), moved.rend()).least;
  const auto count = static_cast<std::uint32_t>(here.size());
  const Seam parting = parting_of(here, moved, range);
  if (stay + move > count) return parting;  // some fit both ways
  Seam seam{range.first + stay, range.end - move};
  if (parting.first != seam.first && parting.first != seam.end) seam.split = parting.first;
  return seam;
}

Seam parting_of(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                const KnownScene& scene, const AssociationGates& gates) {
  return parting_of(gains(lines, range, Pose::Identity(), scene, gates),
                    gains(lines, range, T_start_start, scene, gates), range);
}

std::uint32_t end_of_fitting(const PosedLines& lines, const LineRange& range,
                             const KnownScene& scene, const AssociationGates& gates) {
  const std::vector<double> here = gains(lines, range, Pose::Identity(), scene, gates);
  return range.first + best_start(here.begin(), here.end()).least;
}

std::uint32_t last_seen(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                        const KnownScene& scene, const AssociationGates& gates) {
  std::vector<std::pair<std::uint32_t, double>> seen;  // line and length
  double total = 0.0;
  for (const KnownRibbon& ribbon : known_ribbons(lines, range, T_start_start, scene, gates)) {
    seen.emplace_back(ribbon.wall->last_line, ribbon.length_m);
    total += ribbon.length_m;
  }
  std::sort(seen.begin(), seen.end());
  double sum = 0.0;
  for (const auto& [line, length] : seen) {
    sum += length;
    if (sum >= 0.75 * total) return line;
  }
  return range.first;
}

void move_behind(const Seam& seam, const Pose& T_start_start, PosedLines& lines) {
  const double steps = seam.end + 1.0 - seam.first;
  for (std::uint32_t i = seam.first; i < lines.size(); ++i) {
    const double part = std::min(1.0, (i + 1.0 - seam.first) / steps);
    lines.set_pose(i, moved_in_part(lines.T_start_base(i), T_start_start, part));
  }
}

double scale_of(const Seam& seam, const Pose& T_start_start, const PosedLines& lines) {
  TrajectorySegment span;
  for (std::uint32_t i = seam.first; i <= seam.end; ++i) span.steps.push_back(lines.step(i));
  span.T_frame_start = lines.T_start_base(seam.first - 1);
  span.T_frame_end = T_start_start * lines.T_start_base(seam.end);
  return fitted_noise({span}).planar_scale;
}

std::optional<std::uint32_t> most_strained(const PosedLines& lines, const LineRange& range,
                                           double max_scale) {
  std::optional<std::uint32_t> worst;
  std::uint32_t last_slip = 0;
  std::uint32_t first = std::max<std::uint32_t>(1, range.first);
  for (std::uint32_t i = first; i < range.end; ++i) {
    if (lines.is_slip(i)) last_slip = i;
    while (lines.seconds_between(first, i) > kStrain_s) ++first;
    if (last_slip >= first || lines.seconds_between(range.first, i) < kStrain_s) continue;
    const double scale = scale_of({first, i}, Pose::Identity(), lines);
    if (scale > max_scale) worst = first, max_scale = scale;
  }
  return worst;
}

}  // namespace ribbon_mapper::slam
