// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "eval/metrics/map_metrics.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::eval {

/// Returns how well outlines enclose what the beams truly saw: the intersection over union of each
/// true plane and its match, weighted by the true area. A missed plane counts as 0.
///
/// The true area is that of the true plane's cells, with stripes between scan lines closed as in
/// the outlines (SurfaceConfig::stripe_gap_m), but exact. Outlines are projected on the true plane.
/// Returns nothing if there is no true plane, or if no estimate has outlines.
std::optional<double> outline_iou(const std::vector<Plane>& estimates,
                                  const std::vector<Plane>& truth,
                                  const std::vector<Match>& matches);

}  // namespace ribbon_mapper::eval
