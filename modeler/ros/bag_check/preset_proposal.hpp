// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/modeler_config.hpp"
#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper {

/// Returns a preset for the laser of a recording, as YAML with the measured values as comments.
/// `preset` has the values of keys that a recording does not tell. If the robot stands, the gates
/// of association are widened while that lets planes grow. Throws what BagLines throws, and
/// std::runtime_error if no line has poses.
std::string proposed_preset(const std::vector<std::filesystem::path>& bags,
                            const BagOptions& options, const ModelerConfig& preset);

}  // namespace ribbon_mapper
