// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/results/results.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/program/progress.hpp"
#include "sim/tour/route.hpp"
#include "sim/tour/tour.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::eval {

/// The paper's experiment in one process: a tour with noisy localisation is modelled on the way;
/// at its end the model takes over the true trajectory (a virtual loop closure). The same arguments
/// give the same planes, byte for byte; only times differ. `summary` names its command, world and
/// route as the caller sets them. Throws what Tour and Modeler throw.
Results run_experiment(const sim::World& world, const sim::Route& route,
                       const sim::TourConfig& tour, const ModelerConfig& modeler,
                       const ProgressCallback& progress);

}  // namespace ribbon_mapper::eval
