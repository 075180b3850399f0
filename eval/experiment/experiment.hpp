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

/// What corrects the trajectory at the end of a tour.
enum class Closure {
  truth,                ///< the true trajectory: the virtual loop closure of the paper
  self,                 ///< an estimate from odometry and ribbons
  self_with_base_laser  ///< the same, with odometry that the base laser refines
};

/// Runs the paper's experiment in one process. A tour with noisy localisation is modelled; at its
/// end the model is corrected by the true trajectory, a virtual loop closure. The planes are
/// reproducible to the byte, the times are not. The caller sets `run` and `command` of the summary.
/// Throws as sim::Tour and Modeler.
Results run_experiment(const sim::World& world, const sim::Route& route,
                       const sim::TourConfig& tour, const ModelerConfig& modeler, Closure closure,
                       const ProgressCallback& progress);

}  // namespace ribbon_mapper::eval
