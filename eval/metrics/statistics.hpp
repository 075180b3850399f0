// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ribbon_mapper::eval {

/// Between the sorted values, linearly, as numpy.quantile() does it: 0.5 is the median. Of no
/// values: not a number.
double quantile(std::vector<double> values, double share);

/// Of no values: not a number.
double mean_of(const std::vector<double>& values);

}  // namespace ribbon_mapper::eval
