// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/history_cost.hpp"

namespace ribbon_mapper::slam {

HistoryCost history_cost(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
                         const EstimateSettings& settings) {
  double ribbons = 0.0, length_m = 0.0, unexplained_m = 0.0;
  HistoryCost cost;
  for (const std::uint32_t line : indices) {
    for (std::uint32_t i = lines.first_ribbon(line); i < lines.first_ribbon(line + 1); ++i) {
      ribbons += 1.0, length_m += lines.ribbon(i).length_m;
      ++cost.unexplained;
    }
  }
  unexplained_m = length_m;
  for (const Hypothesis& plane :
       planes_of(lines, indices, settings.estimate.gates.back(), settings)) {
    ++cost.planes;
    cost.unexplained -= plane.members().size();
    for (const Member& member : plane.members()) {
      unexplained_m -= lines.ribbon(member.ribbon).length_m;
    }
  }
  cost.total = settings.registration.min_ribbons * static_cast<double>(cost.planes);
  if (length_m == 0.0) return cost;
  cost.ribbon_m = length_m / ribbons;
  cost.total += unexplained_m / cost.ribbon_m;
  return cost;
}

}  // namespace ribbon_mapper::slam
