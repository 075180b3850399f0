// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/context.hpp"

#include <algorithm>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper::slam {
namespace {

// The robot hardly moves within so many lines (half a second at 40 Hz): one stands for all.
constexpr std::uint32_t kLinesOfPlace = 20;

}  // namespace

std::uint32_t first_within(const PosedLines& lines, double seconds) {
  const std::uint32_t last = lines.size() - 1;
  const std::uint32_t first = lines_before(seconds, lines, last).first;
  return std::min(last, std::max<std::uint32_t>(1, first));
}

LineRange newest_within(const PosedLines& lines, double seconds) {
  return {first_within(lines, seconds), lines.size()};
}

LineRange lines_within(double seconds, const PosedLines& lines, std::uint32_t first,
                       std::uint32_t end) {
  LineRange range{first, first};
  while (range.end < end && lines.seconds_between(first, range.end) < seconds) ++range.end;
  return range;
}

LineRange lines_before(double seconds, const PosedLines& lines, std::uint32_t end) {
  LineRange range{end, end};
  while (range.first > 0 && lines.seconds_between(range.first - 1, end) < seconds) --range.first;
  return range;
}

double way_since(std::uint32_t line, const PosedLines& lines) {
  double way_m = 0.0;
  for (std::uint32_t i = line + 1; i < lines.size(); ++i) {
    way_m += (lines.T_start_base(i).translation() - lines.T_start_base(i - 1).translation()).norm();
  }
  return way_m;
}

std::vector<Eigen::Vector3d> places_of(const PosedLines& lines, const LineRange& range,
                                       const Pose& T_start_start) {
  std::vector<Eigen::Vector3d> places;
  for (std::uint32_t i = range.first; i < range.end; i += kLinesOfPlace) {
    places.push_back(T_start_start * lines.T_start_base(i).translation());
  }
  return places;
}

std::vector<std::uint32_t> lines_near(const std::vector<Eigen::Vector3d>& places, double radius_m,
                                      const PosedLines& lines, std::uint32_t end,
                                      const EstimateConfig& config) {
  const auto is_near = [&](const Eigen::Vector3d& place) {
    return std::any_of(places.begin(), places.end(), [&](const Eigen::Vector3d& other) {
      return (place - other).squaredNorm() < square(radius_m);
    });
  };
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < end; i += kLinesOfPlace) {
    if (!is_near(lines.T_start_base(i).translation())) continue;
    for (std::uint32_t k = i; k < std::min(end, i + kLinesOfPlace); ++k) near.push_back(k);
  }
  const auto most = static_cast<std::size_t>(config.max_context_lines);
  if (near.size() <= most) return near;
  for (std::size_t i = 0; i < most; ++i) near[i] = near[i * near.size() / most];
  near.resize(most);
  return near;
}

std::vector<std::uint32_t> context_of(const PosedLines& lines, const LineRange& range,
                                      std::uint32_t end, const EstimateConfig& config) {
  return lines_near(places_of(lines, range), config.context_radius_m, lines, end, config);
}

}  // namespace ribbon_mapper::slam
