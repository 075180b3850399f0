// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper {

/// What a user of `bag_check` can choose.
struct BagCheckOptions {
  std::vector<std::filesystem::path> bags;
  std::string config;  ///< preset for the check of the time offset; empty: no such check
  BagOptions bag;
};

/// The options, or the exit code of a program that has said what was to be said (0: help, 2:
/// usage).
std::variant<BagCheckOptions, int> parse_bag_check_options(int argc, const char* const* argv);

/// The options that all programs for bags share: topic, frames, time offset, what tf leaves out.
void add_bag_options(CLI::App& app, BagOptions& options, std::string& tf_drop_frames);

/// To be called after parsing.
void finish_bag_options(BagOptions& options, const std::string& tf_drop_frames);

}  // namespace ribbon_mapper
