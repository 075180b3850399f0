// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/segmentation/duplication.hpp"

namespace ribbon_mapper::eval {

Duplication duplication(const Overlaps& overlaps) {
  std::size_t found = 0, estimates = 0;
  for (std::size_t t = 0; t < overlaps.truth(); ++t) {
    std::size_t of_this = 0;
    for (std::size_t e = 0; e < overlaps.estimates(); ++e) {
      if (overlaps.share_of_estimate(t, e) > 0.5) ++of_this;
    }
    estimates += of_this;
    found += of_this > 0 ? 1 : 0;
  }
  Duplication result;
  result.duplicates = estimates - found;
  if (found > 0) result.ratio = static_cast<double>(estimates) / static_cast<double>(found);
  return result;
}

}  // namespace ribbon_mapper::eval
