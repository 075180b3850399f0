// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "eval/experiment/run_options.hpp"
#include "modeler/program/progress_bar.hpp"

namespace ribbon_mapper::eval {

/// Makes a run to its end and returns what is to be printed of it.
using Run = std::function<std::string(const RunOptions& run, const ProgressCallback& progress)>;

/// Makes the runs, `jobs` at a time, and prints what each of them returns. A run that throws stops
/// those that have not begun; its exception is thrown when those that have are done.
void make_runs(const std::vector<RunOptions>& runs, std::size_t jobs, const Run& run,
               ProgressBar& bar);

}  // namespace ribbon_mapper::eval
