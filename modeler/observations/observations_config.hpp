// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How much a model remembers.
struct ObservationsConfig {
  /// Largest number of ribbons in the model (0: no limit). When it is exceeded, an eighth of them
  /// is removed where the same surface was seen most often. The error of a plane there grows with
  /// the square root of the reduction. A ribbon takes about 400 bytes with all that depends on it.
  int max_ribbons = 1'000'000;
};

}  // namespace ribbon_mapper
