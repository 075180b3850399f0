// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "eval/results/run_log.hpp"

namespace ribbon_mapper::eval {

// A series of runs as a table: a head, a row per run, and at the foot the minimum, median and
// maximum of each column. Runs that differ only in their seeds are a group with a foot of its own.

/// Returns the two lines of column heads.
std::string series_table_head(std::size_t label_width);

/// Returns the row of one run.
std::string series_table_row(const std::string& label, const LoggedRun& run,
                             std::size_t label_width);

/// Returns the foot of every group and the number of right runs. `runs` must be sorted by
/// comes_before().
std::string series_table_foot(const std::vector<LoggedRun>& runs, std::size_t label_width);

/// Returns the width of the longest label of these runs, with a space.
std::size_t label_width_of(const std::vector<RunOptions>& runs);

/// Summarises a series as JSON: {"command", "version", "runs", "right", "groups": [{conditions,
/// "runs", "right", "distribution": {key: {"min", "lower_quartile", "median", "upper_quartile",
/// "max"}}}]}. Keys are those of runs.jsonl, with nested keys joined by dots. A run is right if no
/// plane is missed, extra or duplicated after the correction.
std::string series_summary_to_json(const std::vector<LoggedRun>& runs, const std::string& command);

}  // namespace ribbon_mapper::eval
