// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "eval/results/run_log.hpp"

namespace ribbon_mapper::eval {

// Many runs as a table: a head, a row per run, and per group of runs that differ in nothing but
// their seeds the least, the median and the most of each column.

std::string series_table_head(std::size_t label_width);
std::string series_table_row(const std::string& label, const LoggedRun& record,
                             std::size_t label_width);
/// Of all groups, and how many runs found the truth. `records` as RunLog sorts them.
std::string series_table_foot(const std::vector<LoggedRun>& records, std::size_t label_width);

/// Room for the longest label of these runs.
std::size_t label_width_of(const std::vector<RunOptions>& runs);

/// {"command", "version", "runs", "right", "groups": [{the conditions, "runs", "right", "spread":
/// {key: {"least", "lower_quartile", "median", "upper_quartile", "most"}}}]}: keys as in
/// runs.jsonl, those of objects joined by dots; `right`: runs without a missed, extra or double
/// plane after the correction.
std::string series_summary_to_json(const std::vector<LoggedRun>& records,
                                   const std::string& command);

}  // namespace ribbon_mapper::eval
