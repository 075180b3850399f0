// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/calibration/calibration.hpp"

namespace ribbon_mapper {

/// The preset with the tolerances that were learned, for load_config(); V_sensor, V_slam and
/// `source` (what they were learned from) in comments above.
std::string calibrated_preset(const ModelerConfig& config, const Calibration& calibration,
                              const std::string& source);

}  // namespace ribbon_mapper
