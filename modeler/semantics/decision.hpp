// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "modeler/semantics/label.hpp"

namespace ribbon_mapper {

/// A label, and how sure it is.
struct Decision {
  Label label = Label::furniture;  ///< what the rules say
  double confidence = 0.0;         ///< from 0 to 1; 0.5: a measured size lies on a rule's limit
};

/// Returns the probability that a size is on the side of a limit where it was measured: `margin`
/// beyond the limit, with a normal error of this standard deviation.
inline double certainty(double margin, double sigma) {
  return 0.5 * std::erfc(-std::abs(margin) / (std::sqrt(2.0) * sigma));
}

/// Returns a decision that depends on another measured size as well.
inline Decision given(Decision decision, double certainty_of_size) {
  decision.confidence = std::min(decision.confidence, certainty_of_size);
  return decision;
}

}  // namespace ribbon_mapper
