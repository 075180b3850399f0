// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/prctl.h>

#include "bench/lines/line_times.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

/// Names the thread after the stage, which is how the profiler distinguishes stages.
void enter(const char* stage) { prctl(PR_SET_NAME, stage); }

}  // namespace

// The work for bench/figures/profile.py; there is nothing to report.
void run_for_profile(const Inputs& inputs, Report& /*report*/) {
  const auto truth = true_trajectory(inputs.recording);
  for (int i = 0; i < inputs.options.repetitions; ++i) {
    Modeler modeler(inputs.config);
    enter("lines");
    feed(inputs.recording, modeler);
    enter("correct");
    modeler.correct(truth);
    enter("planes");
    keep(modeler.planes());
    enter("bench");
  }
}

}  // namespace ribbon_mapper::bench
