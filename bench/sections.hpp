// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench/options.hpp"
#include "bench/recording/recording.hpp"
#include "bench/report.hpp"
#include "modeler/modeler_config.hpp"

namespace ribbon_mapper::bench {

/// What a section is given.
struct Inputs {
  Options options;
  ModelerConfig config;
  Recording recording;  ///< the tour of the flat, drift 3; or a bag
};

void measure_normals(const Inputs& inputs, Report& report);
void measure_lines(const Inputs& inputs, Report& report);
void measure_planes(const Inputs& inputs, Report& report);
void measure_corrections(const Inputs& inputs, Report& report);
void measure_memory(const Inputs& inputs, Report& report);
void measure_rays(const Inputs& inputs, Report& report);
void measure_growth(const Inputs& inputs, Report& report);
void run_for_profile(const Inputs& inputs, Report& report);

/// Throws std::runtime_error if nothing of a bag can be modelled: there is nothing to measure.
void require_ribbons(const Inputs& bag);

/// What can be measured without a truth, of each bag.
void measure_bags(const std::vector<Inputs>& bags, Report& report);

// Parts of sections that any recording will do for.
void measure_recorded_lines(const Inputs& inputs, Report& report);
void measure_recorded_planes(const Inputs& inputs, Report& report);

}  // namespace ribbon_mapper::bench
