// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/experiment/experiment.hpp"
#include "eval/experiment/run_options.hpp"

namespace ribbon_mapper::eval {

/// The simulated tour that these options ask for.
sim::TourConfig tour_config(const RunOptions& run);

/// The preset of these options. Throws std::invalid_argument as load_config() does.
ModelerConfig modeler_config(const RunOptions& run);

/// The world of these options, for one thread alone. Throws what World::load() throws.
sim::World load_world(const RunOptions& run);

/// The route at the speed that was asked for. Throws what Route::load() throws.
sim::Route load_route(const RunOptions& run);

/// run_experiment() with what the options name. Throws std::runtime_error or std::invalid_argument
/// that says what is wrong with a file or a value.
Results make_run(const RunOptions& run, const ProgressCallback& progress);

}  // namespace ribbon_mapper::eval
