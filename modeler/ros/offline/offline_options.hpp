// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper {

/// What a user of `offline_modeler` can choose.
struct OfflineOptions {
  std::vector<std::filesystem::path> bags;
  std::filesystem::path trajectory;  ///< TUM file; empty: the recorded poses
  bool poses_are_final = false;      ///< the recorded poses are as good as corrected ones
  std::string config = "config/pr2.yaml";
  std::filesystem::path output = "results/offline";
  bool with_figure = false;
  BagOptions bag;
};

/// The options, or the exit code of a program that has said what was to be said (0: help, 2:
/// usage).
std::variant<OfflineOptions, int> parse_offline_options(int argc, const char* const* argv);

}  // namespace ribbon_mapper
