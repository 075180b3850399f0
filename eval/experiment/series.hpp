// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "eval/experiment/run_options.hpp"
#include "modeler/program/progress_bar.hpp"

namespace ribbon_mapper::eval {

/// Makes one run, reports its progress and returns the text to print.
using MakeRun = std::function<std::string(const RunOptions& run, const ProgressCallback& progress)>;

/// Makes all runs of a series, `jobs` at a time, and prints the text of each. After a run has
/// thrown, no further run begins. Rethrows the first exception when the current runs have ended. A
/// program that was asked to end ends them early, see stop_if_interrupted().
void make_runs(const std::vector<RunOptions>& runs, std::size_t jobs, const MakeRun& make_run,
               ProgressBar& bar);

}  // namespace ribbon_mapper::eval
