// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/options.hpp"
#include "bench/recording/recording.hpp"
#include "bench/report.hpp"
#include "modeler/modeler_config.hpp"

namespace ribbon_mapper::bench {

/// What all sections are given.
struct Inputs {
  Options options;
  ModelerConfig config;
  Recording tour;  ///< the flat, drift 3
};

void measure_normals(const Inputs& inputs, Report& report);
void measure_lines(const Inputs& inputs, Report& report);
void measure_planes(const Inputs& inputs, Report& report);
void measure_corrections(const Inputs& inputs, Report& report);
void measure_memory(const Inputs& inputs, Report& report);
void measure_rays(const Inputs& inputs, Report& report);
void measure_growth(const Inputs& inputs, Report& report);
void run_for_profile(const Inputs& inputs, Report& report);

}  // namespace ribbon_mapper::bench
