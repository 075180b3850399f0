// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/planes/planes_peer.hpp"
#include "eval/metrics/map_metrics.hpp"
#include "modeler/association/association_config.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::bench {

/// The planes of a peer as we have them: least-squares planes with cells of our size, turned to
/// where they were seen from; those below our least area left out.
std::vector<Plane> bounded_planes(const std::vector<Points>& planes, const ViewField& views,
                                  const ModelerConfig& config);

/// Unites planes of single sweeps that are one: what a user of PCL has to write as well. It is not
/// timed.
std::vector<Points> united(const std::vector<Points>& planes);

nlohmann::json to_json(const eval::MapMetrics& metrics);

/// What can be said of planes without a truth: their number and area, doubled ones, the share of
/// all points that lie on one (within 10 cm, where it has cells), and how far from it these are.
nlohmann::json judged_by_points(const std::vector<Plane>& planes, const Points& points,
                                const ModelerConfig& config);

/// Of either.
std::string text_of(const nlohmann::json& metrics);

}  // namespace ribbon_mapper::bench
