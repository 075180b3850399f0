// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "eval/metrics/overlaps.hpp"

namespace ribbon_mapper::eval {

/// What SegComp says of a segmentation (Hoover et al. 1996, An experimental comparison of range
/// image segmentation algorithms). Every true region is correct, over-segmented, under-segmented
/// (one of those that a single estimate lumps together) or missed; every estimate is correct, one
/// of the pieces of an over-segmented region, under-segmented or noise.
struct SegComp {
  std::size_t truth = 0;              ///< regions
  std::size_t estimates = 0;          ///< regions
  std::size_t correct = 0;            ///< pairs
  std::size_t over = 0;               ///< true regions that several estimates share
  std::size_t under = 0;              ///< estimates that cover several true regions
  std::vector<std::size_t> missed;    ///< indices of true regions
  std::vector<std::size_t> noise;     ///< indices of estimates
  double correct_share = 0.0;         ///< correct / truth
  double correct_points_share = 0.0;  ///< points of correct true regions / of all true regions
};

/// Shares must exceed `tolerance`, pair by pair as in Hoover's compare.c. It must be 0.5 or more:
/// then a region has at most one partner of each class. Where classes compete for a region, the
/// one with the higher mean share takes it; correct wins a tie, then over-segmentation, then the
/// lower index. Throws std::invalid_argument for another tolerance.
SegComp segcomp(const Overlaps& overlaps, double tolerance = 0.8);

}  // namespace ribbon_mapper::eval
