// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/planes/planes_peer.hpp"
#include "eval/map_metrics.hpp"

namespace ribbon_mapper::bench {

/// The planes of a peer as the metrics know them: least-squares planes with their 5 cm cells,
/// turned to where they were seen from; those below `least_area_m2` left out, as with us.
std::vector<eval::Patch> patches_of(const std::vector<Points>& planes, const ViewField& views,
                                    double least_area_m2);

/// Unites planes of single sweeps that are one: what a user of PCL has to write as well. It is not
/// timed.
std::vector<Points> united(const std::vector<Points>& planes);

nlohmann::json to_json(const eval::MapMetrics& metrics);
std::string text_of(const nlohmann::json& metrics);

}  // namespace ribbon_mapper::bench
