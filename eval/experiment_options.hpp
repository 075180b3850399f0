// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace ribbon_mapper::eval {

/// What a user of `experiment` can choose.
struct ExperimentOptions {
  std::string world = "worlds/apartment.sdf";
  std::string route;  ///< empty: beside the world, <name>.route.yaml
  std::string config = "config/pr2.yaml";
  std::vector<std::string> model_paths;
  double drift = 3.0;  ///< where the paper's 110 planes come from
  std::string noise = "datasheet";
  std::string tilt = "manip";

  std::vector<std::uint64_t> seeds{1};
  bool many_seeds = false;  ///< one folder per seed, and figures over all of them
  std::size_t jobs = 1;

  std::filesystem::path output = "results/experiment";
  bool with_figure = true;
};

/// The options, or the exit code of a program that has said what was to be said (0: help, 2:
/// usage).
std::variant<ExperimentOptions, int> parse_experiment_options(int argc, const char* const* argv);

/// Seeds of a list such as "1-20" or "1,3,7..9". Throws std::invalid_argument that shows the form.
std::vector<std::uint64_t> seeds_from(const std::string& list);

/// Where the route of these options is.
std::filesystem::path route_path(const ExperimentOptions& options);

/// The command that makes the run of one seed again.
std::string command_of(const ExperimentOptions& options, std::uint64_t seed);

}  // namespace ribbon_mapper::eval
