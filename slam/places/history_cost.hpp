// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "slam/lines/known_planes.hpp"

namespace ribbon_mapper::slam {

/// What it takes to explain the ribbons of some lines at their poses [ribbons]: those on no plane,
/// each by its length as a part of the mean, and RegistrationConfig::min_ribbons for each plane.
///
/// Of two histories, the one of less cost is more likely: it explains as much by fewer planes
/// (minimum description length, Rissanen 1978). A plane costs as many ribbons as it takes to
/// believe in it. Residuals do not tell a right history from a wrong one.
struct HistoryCost {
  std::size_t planes = 0;       ///< number of planes
  std::size_t unexplained = 0;  ///< number of ribbons on no plane
  double ribbon_m = 0.0;        ///< mean length of the ribbons
  double total = 0.0;           ///< [ribbons]
};

/// Computes the cost of lines at their poses.
HistoryCost history_cost(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
                         const EstimateSettings& settings);

}  // namespace ribbon_mapper::slam
