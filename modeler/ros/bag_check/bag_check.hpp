// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "modeler/modeler_config.hpp"
#include "modeler/ros/bag/bag_lines.hpp"
#include "modeler/ros/bag_check/bag_report.hpp"

namespace ribbon_mapper {

/// Finds out whether bags can be mapped with a preset, and what is wrong with them. Models them, so
/// that the verdict is that of the modelers. Never throws because of a bag: one that cannot be read
/// is a fault in the report.
BagReport check_bags(const std::vector<std::filesystem::path>& files, const BagOptions& options,
                     const ModelerConfig& preset = {});

}  // namespace ribbon_mapper
