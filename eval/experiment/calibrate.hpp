// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "eval/experiment/run_options.hpp"
#include "modeler/calibration/calibration.hpp"
#include "modeler/program/progress.hpp"

namespace ribbon_mapper::eval {

/// Runs the calibration of section 5.1 in the simulator. Throws as Calibrator::result(),
/// load_world(), load_route() and modeler_config().
Calibration make_calibration(const RunOptions& run, const ProgressCallback& progress);

}  // namespace ribbon_mapper::eval
