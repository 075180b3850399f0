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

/// Command line options of `bag_check`.
struct BagCheckOptions {
  std::vector<std::filesystem::path> bags;  ///< read as one
  std::string config = "config/pr2.yaml";   ///< preset that the bag is judged by
  std::filesystem::path proposed_preset;    ///< file to write a preset to; empty: none
  BagOptions bag;                           ///< topic, frames and times
};

/// Returns the options, or the exit code if the program has printed its help (0) or a usage error
/// (2).
std::variant<BagCheckOptions, int> parse_bag_check_options(int argc, const char* const* argv);

/// Adds the options that all programs for bags share: topic, frames, time offset, dropped
/// transforms.
void add_bag_options(CLI::App& app, BagOptions& options, std::string& tf_drop_frames);

/// Completes the shared options; to be called after parsing.
void finish_bag_options(BagOptions& options, const std::string& tf_drop_frames);

}  // namespace ribbon_mapper
