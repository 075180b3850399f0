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

struct TimeOffset {
  double offset_s = 0.0;         ///< to be added to the stamps of the scans
  double thickness_m = 0.0;      ///< of the planes with it: root mean square distance of the points
  double thickness_now_m = 0.0;  ///< of the planes as they are
};

/// The constant error of the laser's stamps. Where stamps are off, planes of an up sweep and of a
/// down sweep lean apart; the offset that makes them the same leaves the thinnest planes. Looks at
/// the first half minute. Nothing if that does not depend on the offset: the tilt stands still or
/// turns one way only, or there are no planes.
std::optional<TimeOffset> estimate_time_offset(const std::vector<std::filesystem::path>& bags,
                                               const BagOptions& options,
                                               const ModelerConfig& config);

/// The same in words; `preset` is a file. Throws what load_config() throws.
void report_time_offset(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                        const std::string& preset, BagReport& report);

}  // namespace ribbon_mapper
