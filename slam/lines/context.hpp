// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "slam/lines/estimate_config.hpp"
#include "slam/lines/posed_lines.hpp"

namespace ribbon_mapper::slam {

/// Lines [first, end).
struct LineRange {
  std::uint32_t first = 0;  ///< the first one
  std::uint32_t end = 0;    ///< one behind the last
};

/// Returns the first line, but not line 0, that is younger than `seconds` at the newest line.
std::uint32_t first_within(const PosedLines& lines, double seconds);

/// Returns the lines from first_within() on.
LineRange newest_within(const PosedLines& lines, double seconds);

/// Returns the lines from `first` on within a time, and before `end`.
LineRange lines_within(double seconds, const PosedLines& lines, std::uint32_t first,
                       std::uint32_t end);

/// Returns the lines before `end` within a time.
LineRange lines_before(double seconds, const PosedLines& lines, std::uint32_t end);

/// Returns the length of the way from a line to the newest one [m].
double way_since(std::uint32_t line, const PosedLines& lines);

/// Returns where the robot was in a range, if its lines were moved by `T_start_start` [m].
std::vector<Eigen::Vector3d> places_of(const PosedLines& lines, const LineRange& range,
                                       const Pose& T_start_start = Pose::Identity());

/// Returns the lines before `end` within `radius_m` of some places, ascending: at most
/// EstimateConfig::max_context_lines.
std::vector<std::uint32_t> lines_near(const std::vector<Eigen::Vector3d>& places, double radius_m,
                                      const PosedLines& lines, std::uint32_t end,
                                      const EstimateConfig& config);

/// Returns the lines before `end` from near a range, ascending: see
/// EstimateConfig::context_radius_m.
std::vector<std::uint32_t> context_of(const PosedLines& lines, const LineRange& range,
                                      std::uint32_t end, const EstimateConfig& config);

}  // namespace ribbon_mapper::slam
