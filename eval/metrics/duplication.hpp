// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "eval/metrics/overlaps.hpp"

namespace ribbon_mapper::eval {

/// How many estimates share a true plane, by their points: however far drift has carried them, they
/// are told as its copies. An estimate is one of the true plane that most of its points are on.
struct Duplication {
  std::size_t duplicates = 0;   ///< estimates beyond the first of each true plane
  std::optional<double> ratio;  ///< estimates per true plane that has any
};

Duplication duplication(const Overlaps& overlaps);

}  // namespace ribbon_mapper::eval
