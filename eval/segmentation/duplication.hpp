// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "eval/segmentation/overlaps.hpp"

namespace ribbon_mapper::eval {

/// Number of estimates of the same true plane, counted by points. Copies are recognised however far
/// drift has displaced them.
struct Duplication {
  std::size_t duplicates = 0;   ///< estimates beyond the first of each true plane
  std::optional<double> ratio;  ///< estimates per true plane that has any
};

/// Counts duplicates. An estimate belongs to the true plane with more than half of its points.
Duplication duplication(const Overlaps& overlaps);

}  // namespace ribbon_mapper::eval
