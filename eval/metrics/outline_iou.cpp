// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/outline_iou.hpp"

#include <algorithm>

#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/surface/outline.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper::eval {

std::optional<double> outline_iou(const std::vector<Plane>& estimates,
                                  const std::vector<Plane>& truth,
                                  const std::vector<Match>& matches) {
  const bool have_outlines = std::any_of(estimates.begin(), estimates.end(),
                                         [](const Plane& p) { return !p.outlines.empty(); });
  if (truth.empty() || !have_outlines) return std::nullopt;
  std::vector<Polygons> areas;
  double whole = 0.0, weighted = 0.0;
  for (const Plane& plane : truth) {
    areas.push_back(seen_area(plane, SurfaceConfig{}.stripe_gap_m, 0.0));
    whole += area(areas.back());
  }
  for (const Match& match : matches) {
    const Polygons& seen = areas[match.truth];
    const Polygons estimate = areas_of(truth[match.truth], estimates[match.estimate].outlines);
    const double shared = area(intersection(seen, estimate));
    weighted += area(seen) * shared / (area(seen) + area(estimate) - shared);
  }
  return weighted / whole;
}

}  // namespace ribbon_mapper::eval
