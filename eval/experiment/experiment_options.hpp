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
#include "modeler/mesh/mesh_file.hpp"

namespace ribbon_mapper::eval {

/// Command line options of `experiment`.
struct ExperimentOptions {
  std::vector<RunOptions> runs{RunOptions()};  ///< all combinations of the given lists
  bool is_series = false;  ///< several runs or `--seeds`: writes runs.jsonl and a summary
  std::size_t jobs = 1;    ///< runs at a time

  std::filesystem::path output = "results/experiment";     ///< folder for the results
  bool with_figure = true;                                 ///< draw a figure
  bool with_floor_plan = false;                            ///< draw the floor plan
  std::vector<MeshFormat> mesh_formats{MeshFormat::gltf};  ///< of the mesh of the planes
  bool line_only = false;  ///< print the lines of runs.jsonl, write no files
  bool calibrate = false;  ///< learn the tolerances instead
  std::string command;     ///< the command line as given
};

/// Parses the command line. Returns the exit code instead if the program is to end: 0 after --help,
/// 2 after an error message about wrong usage.
std::variant<ExperimentOptions, int> parse_experiment_options(int argc, const char* const* argv);

/// Parses a list of seeds such as "1-20" or "1,3,7..9" into ascending unique seeds. Throws
/// std::invalid_argument with an example of the form.
std::vector<std::uint64_t> seeds_from(const std::string& list);

}  // namespace ribbon_mapper::eval
