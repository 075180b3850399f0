// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "eval/experiment/run_options.hpp"

namespace ribbon_mapper::eval {

/// What a user of `experiment` can choose.
struct ExperimentOptions {
  std::vector<RunOptions> runs{RunOptions()};  ///< every combination of the lists that were given
  bool is_series = false;  ///< several runs, or `--seeds`: a line for each, and figures over all
  std::size_t jobs = 1;

  std::filesystem::path output = "results/experiment";
  bool with_figure = true;
  bool line_only = false;  ///< print the lines of runs.jsonl, write nothing
  bool calibrate = false;  ///< learn tolerances instead
  std::string command;     ///< as it was given
};

/// The options, or the exit code of a program that has said what was to be said (0: help, 2:
/// usage).
std::variant<ExperimentOptions, int> parse_experiment_options(int argc, const char* const* argv);

/// Seeds of a list such as "1-20" or "1,3,7..9". Throws std::invalid_argument that shows the form.
std::vector<std::uint64_t> seeds_from(const std::string& list);

}  // namespace ribbon_mapper::eval
