// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench/options.hpp"
#include "bench/recording/recording.hpp"
#include "bench/report.hpp"
#include "modeler/modeler_config.hpp"

namespace ribbon_mapper::bench {

/// Input of a section.
struct Inputs {
  Options options;       ///< command line options
  ModelerConfig config;  ///< preset
  Recording recording;   ///< the tour of the apartment, or a bag
};

/// Measures time and accuracy of normals.
void measure_normals(const Inputs& inputs, Report& report);

/// Measures the time of lines with 380, 720 and 1040 beams.
void measure_lines(const Inputs& inputs, Report& report);

/// Measures time and accuracy of planes, with true and with noisy poses.
void measure_planes(const Inputs& inputs, Report& report);

/// Measures the time from a corrected trajectory to a consistent map.
void measure_corrections(const Inputs& inputs, Report& report);

/// Measures the memory of the map.
void measure_memory(const Inputs& inputs, Report& report);

/// Measures the time and memory of maps of free space.
void measure_maps(const Inputs& inputs, Report& report);

/// Measures the simulator's rays per second.
void measure_rays(const Inputs& inputs, Report& report);

/// Measures how times and memory grow with the size of the world.
void measure_growth(const Inputs& inputs, Report& report);

/// Runs lines, corrections and planes for a profiler; reports nothing.
void run_for_profile(const Inputs& inputs, Report& report);

/// Throws std::runtime_error if a bag yields no ribbons and thus nothing to measure.
void require_ribbons(const Inputs& bag);

/// Measures for each bag what needs no ground truth.
void measure_bags(const std::vector<Inputs>& bags, Report& report);

/// Measures the time of a recording's lines.
void measure_recorded_lines(const Inputs& inputs, Report& report);

/// Measures time and quality of planes without a ground truth.
void measure_recorded_planes(const Inputs& inputs, Report& report);

}  // namespace ribbon_mapper::bench
