// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "eval/metrics/overlaps.hpp"

namespace ribbon_mapper::eval {

/// Plane-to-plane scores of EVOPS (Kornilova et al., arXiv 2204.05799), as prime-slam/evops-metrics
/// computes them: a pair is whole at an intersection over union of 0.75, partial at 0.2 (>=).
struct Evops {
  std::size_t matched = 0;  ///< whole pairs, greedily in the order of true and estimated indices
  double precision = 0.0;   ///< matched / estimates
  double recall = 0.0;      ///< matched / truth
  double f1 = 0.0;
  double under_segmented = 0.0;  ///< USR: share of estimates with several partial partners
  double over_segmented = 0.0;   ///< OSR: share of true planes with several partial partners
  double noise = 0.0;  ///< share of estimates with no partial partner, or one that is not whole and
                       ///< has no other
  double missed = 0.0;  ///< the same of the true planes
};

Evops evops(const Overlaps& overlaps);

}  // namespace ribbon_mapper::eval
