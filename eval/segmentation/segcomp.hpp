// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "eval/segmentation/overlaps.hpp"

namespace ribbon_mapper::eval {

/// SegComp's classification of a segmentation (Hoover et al. 1996, An experimental comparison of
/// range image segmentation algorithms, IEEE PAMI 18(7)). A true region is correct,
/// over-segmented, under-segmented (an estimate joins it with others) or missed. An estimate is
/// correct, part of an over-segmented region, under-segmented or noise.
struct SegComp {
  std::size_t truth = 0;              ///< number of true regions
  std::size_t estimates = 0;          ///< number of estimated regions
  std::size_t correct = 0;            ///< number of correct pairs
  std::size_t over = 0;               ///< number of true regions split into several estimates
  std::size_t under = 0;              ///< number of estimates that join several true regions
  std::vector<std::size_t> missed;    ///< indices of missed true regions
  std::vector<std::size_t> noise;     ///< indices of estimates that are noise
  double correct_share = 0.0;         ///< correct / truth
  double correct_points_share = 0.0;  ///< the same, weighted by points
};

/// Classifies regions by the shares of points that they have in common, as Hoover's compare.c does.
/// Shares must exceed `tolerance`, which makes matches of each class unique from 0.5 on. Where
/// classes compete for a region, the highest mean share wins; ties go to correct, then to
/// over-segmentation, then to the lower index. Throws std::invalid_argument unless
/// 0.5 <= tolerance < 1.
SegComp segcomp(const Overlaps& overlaps, double tolerance = 0.8);

}  // namespace ribbon_mapper::eval
