// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/known_planes.hpp"

namespace ribbon_mapper::slam {

std::vector<Hypothesis> planes_of(const PosedLines& lines,
                                  const std::vector<std::uint32_t>& indices,
                                  const AssociationGates& gates, const EstimateSettings& settings) {
  PlaneMap map(settings.shared.bridged_gap_m, gates);
  for (const std::uint32_t line : indices) {
    const Pose T_start_base = lines.T_start_base(line);
    for (std::uint32_t i = lines.first_ribbon(line); i < lines.first_ribbon(line + 1); ++i) {
      map.add({lines.ribbon(i), T_start_base}, i);
    }
  }
  const auto min_ribbons = static_cast<std::size_t>(settings.registration.min_ribbons);
  std::vector<Hypothesis> planes;
  for (Hypothesis& plane : map.merged_hypotheses()) {
    if (plane.members().size() >= min_ribbons) planes.push_back(std::move(plane));
  }
  return planes;
}

KnownPlanes::KnownPlanes(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
                         const AssociationGates& gates, const EstimateSettings& settings)
    : planes_(planes_of(lines, indices, gates, settings)),
      landmarks_(
          planes_, [&](std::uint32_t ribbon) { return lines.posed_ribbon(ribbon); },
          settings.shared.bridged_gap_m, settings.registration) {}

}  // namespace ribbon_mapper::slam
