// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "modeler/program/stopwatch.hpp"

namespace ribbon_mapper::bench {

using ribbon_mapper::cpu_seconds_of;

/// Returns the value at a quantile by nearest rank; `share` 0.5 is the median. `values` must not be
/// empty.
inline double quantile(std::vector<double> values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// Returns the median. `values` must not be empty.
inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// Prevents the compiler from optimising away the computation of `value`.
template <typename Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace ribbon_mapper::bench
