// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "eval/summary.hpp"

namespace ribbon_mapper::eval {

// Many runs as a table: a head, a row per run, and least, median and most of each column.

std::string spread_head();
std::string spread_row(const Summary& summary);
/// Rows for least, median and most, and a line that says how many runs found the truth.
std::string spread_foot(const std::vector<Summary>& summaries);

/// {"runs", "right", "spread": {key: {"least", "median", "most"}}, "version"}: keys as in
/// summary.json, `right`: runs without a missed, extra or double plane.
std::string spread_to_json(const std::vector<Summary>& summaries);

}  // namespace ribbon_mapper::eval
