// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <vector>

#include "eval/progress_bar.hpp"
#include "eval/summary.hpp"

namespace ribbon_mapper::eval {

/// Runs one seed to its end.
using SeedRun = std::function<Summary(std::uint64_t seed, const ProgressCallback& progress)>;

/// Runs the seeds, `jobs` at a time, and prints a line for each that is done. Returns the summaries
/// in the order of the seeds, however they finished. A seed that throws stops those that have not
/// begun; its exception is thrown when those that have are done.
std::vector<Summary> run_seeds(const std::vector<std::uint64_t>& seeds, std::size_t jobs,
                               const SeedRun& run, ProgressBar& bar);

}  // namespace ribbon_mapper::eval
