// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ribbon_mapper::eval {

/// Returns a quantile by linear interpolation, as numpy.quantile() does; `share` 0.5 is the median.
/// Returns NaN without values.
double quantile(std::vector<double> values, double share);

/// Returns the arithmetic mean, or NaN without values.
double mean_of(const std::vector<double>& values);

}  // namespace ribbon_mapper::eval
