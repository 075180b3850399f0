// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/calibration/calibration.hpp"

namespace ribbon_mapper {

/// Returns a preset for load_config() with the learned tolerances. Comments at its head state
/// `source`, the origin of the data, and the variances V_sensor and V_slam.
std::string calibrated_preset(const ModelerConfig& config, const Calibration& calibration,
                              const std::string& source);

}  // namespace ribbon_mapper
