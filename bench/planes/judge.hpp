// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/planes/planes_peer.hpp"
#include "eval/metrics/map_metrics.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper::bench {

/// Converts planes of a peer to our representation: least-squares planes with cells of our size and
/// normals towards the sensor. Planes below our minimum area are left out.
std::vector<Plane> bounded_planes(const std::vector<Points>& planes, const ViewField& views,
                                  const ModelerConfig& config);

/// Merges equal planes of different sweeps. Users of PCL have to write this as well; it is not
/// timed.
std::vector<Points> united(const std::vector<Points>& planes);

/// Converts metrics to JSON.
nlohmann::json to_json(const eval::MapMetrics& metrics);

/// Evaluates planes without a ground truth: number, area, duplicates, the share of points within
/// 10 cm of a plane's cells, and the median distance of these points.
nlohmann::json judged_by_points(const std::vector<Plane>& planes, const Points& points,
                                const ModelerConfig& config);

/// Formats the metrics of either function as text.
std::string text_of(const nlohmann::json& metrics);

}  // namespace ribbon_mapper::bench
