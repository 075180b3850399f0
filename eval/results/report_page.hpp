// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "eval/results/results.hpp"

namespace ribbon_mapper::eval {

/// Returns a page to look at the results, see Report: three models before and after the correction,
/// the truth, and what it says of each plane. `before` and `truth` are planes with outlines:
/// those as built with the noisy trajectory, and the true ones.
std::string report_page(const Results& results, const std::vector<Plane>& before,
                        const std::vector<Plane>& truth, const std::string& run_id);

}  // namespace ribbon_mapper::eval
