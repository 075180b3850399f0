// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper::slam {

/// Command line options of `offline_slam`.
struct SlamOptions {
  std::vector<std::filesystem::path> bags;        ///< read as one
  std::filesystem::path output = "results/slam";  ///< folder for the results
  bool with_figure = false;                       ///< also draws level_map.png
  BagOptions bag;                                 ///< topics, frames and times
};

/// Returns the options, or the exit code if the program has printed its help (0) or a usage error
/// (2).
std::variant<SlamOptions, int> parse_slam_options(int argc, const char* const* argv);

}  // namespace ribbon_mapper::slam
