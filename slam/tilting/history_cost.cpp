// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/history_cost.hpp"

namespace ribbon_mapper::slam {

HistoryCost history_cost(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
                         const EstimateSettings& settings) {
  HistoryCost cost;
  double total_m = 0.0, explained_m = 0.0;
  std::size_t ribbons = 0;
  for (const std::uint32_t line : indices) {
    for (std::uint32_t i = lines.first_ribbon(line); i < lines.first_ribbon(line + 1); ++i)
      total_m += lines.ribbon(i).length_m, ++ribbons;
  }
  cost.unexplained = ribbons;
  for (const Hypothesis& plane :
       planes_of(lines, indices, settings.estimate.gates.back(), settings)) {
    cost.unexplained -= plane.members().size();
    for (const Member& m : plane.members()) explained_m += lines.ribbon(m.ribbon).length_m;
    ++cost.planes;
  }
  cost.length_m = (total_m - explained_m) / (total_m / static_cast<double>(ribbons));
  cost.total = cost.length_m + settings.registration.min_ribbons * static_cast<double>(cost.planes);
  return cost;
}

}  // namespace ribbon_mapper::slam
