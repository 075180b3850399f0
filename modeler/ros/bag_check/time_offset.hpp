// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "modeler/modeler_config.hpp"
#include "modeler/ros/bag/bag_lines.hpp"
#include "modeler/ros/bag_check/bag_report.hpp"

namespace ribbon_mapper {

/// A time offset of the laser with its effect. The thickness of the planes is the root mean square
/// distance of their points.
struct TimeOffset {
  double offset_s = 0.0;         ///< to be added to the stamps of the scans
  double thickness_m = 0.0;      ///< of the planes with the offset
  double thickness_now_m = 0.0;  ///< of the planes without it
  bool is_clear = false;         ///< the planes get thinner by more than chance, by 3 % at least
  /// The time increment that the offset was found with, if that is not the recorded one.
  std::optional<double> time_increment_s;
};

/// Estimates the constant error of the laser's stamps, up to a second, from the first half minute.
/// If the stamps are off, surfaces of up sweeps and of down sweeps lie apart. The right offset
/// makes them agree: their points lie in the fewest voxels, and make the thinnest planes. If the
/// time increment cannot be meant, the one that fits the period of the lines is tried as well.
/// Returns nothing if the motion cannot tell: the tilt stands still or turns in one direction only,
/// several offsets fit, or there are no planes.
std::optional<TimeOffset> estimate_time_offset(const std::vector<std::filesystem::path>& bags,
                                               const BagOptions& options,
                                               const ModelerConfig& config);

/// Adds the estimate to a report; `preset` is a file. Throws what load_config() throws.
void report_time_offset(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                        const std::string& preset, BagReport& report);

}  // namespace ribbon_mapper
