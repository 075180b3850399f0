// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "eval/segmentation/overlaps.hpp"

namespace ribbon_mapper::eval {

/// Plane-to-plane scores of EVOPS (Kornilova et al. 2022, arXiv:2204.05799), defined as in
/// prime-slam/evops-metrics. A pair is a whole match from an intersection over union of 0.75 on,
/// and a partial match from 0.2 on.
struct Evops {
  std::size_t matched = 0;       ///< whole matches, assigned greedily in the order of the indices
  double precision = 0.0;        ///< matched / estimates
  double recall = 0.0;           ///< matched / true planes
  double f1 = 0.0;               ///< harmonic mean of precision and recall
  double under_segmented = 0.0;  ///< USR: share of estimates with several partial matches
  double over_segmented = 0.0;   ///< OSR: share of true planes with several partial matches
  /// Share of estimates without a partial match, or whose only partial match is neither whole nor
  /// shared.
  double noise = 0.0;
  double missed = 0.0;  ///< share of true planes that meet the same condition
};

/// Computes the scores from the points that true and estimated planes share.
Evops evops(const Overlaps& overlaps);

}  // namespace ribbon_mapper::eval
