// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/experiment/experiment.hpp"
#include "eval/experiment/run_options.hpp"

namespace ribbon_mapper::eval {

/// Returns the configuration of the simulated tour.
sim::TourConfig tour_config(const RunOptions& run);

/// Loads the preset and applies the options to it. Throws std::invalid_argument as load_config().
ModelerConfig modeler_config(const RunOptions& run);

/// Loads the world; it must not be shared by threads. Throws as sim::World::load().
sim::World load_world(const RunOptions& run);

/// Returns what the world of a run holds and what its route sees, with warnings, as lines for the
/// user. Throws as make_run().
std::string world_text(const RunOptions& run);

/// Loads the route at the speed of the options. Throws as sim::Route::load().
sim::Route load_route(const RunOptions& run);

/// Runs the experiment with the files and values of the options. Throws std::runtime_error or
/// std::invalid_argument that names the faulty file or value.
Results make_run(const RunOptions& run, const ProgressCallback& progress);

}  // namespace ribbon_mapper::eval
