// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"
#include "modeler/ros/bag_check/bag_report.hpp"

namespace ribbon_mapper {

/// Whether bags can be mapped, and what is wrong with them. Never throws on account of a bag: what
/// cannot be read is a fault.
BagReport check_bags(const std::vector<std::filesystem::path>& files, const BagOptions& options);

}  // namespace ribbon_mapper
