// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ours beside what a user would take instead: see `bench --help`.

#include <sched.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "bench/recording/tour_recording.hpp"
#include "bench/sections.hpp"
#include "eval/share.hpp"
#include "modeler/io/config_file.hpp"

namespace {

using namespace ribbon_mapper;
using namespace ribbon_mapper::bench;

struct Section {
  const char* name;
  void (*measure)(const Inputs&, Report&);
  bool always = true;  ///< not only when it is asked for
};
constexpr Section kSections[] = {{"normals", measure_normals}, {"lines", measure_lines},
                                 {"planes", measure_planes},   {"corrections", measure_corrections},
                                 {"memory", measure_memory},   {"rays", measure_rays},
                                 {"growth", measure_growth},   {"profile", run_for_profile, false}};

/// One core for all that follows, so that no thread moves and none is added.
void pin_to_one_core() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &cores);
  sched_setaffinity(0, sizeof cores, &cores);
}

void define(CLI::App& app, Options& options) {
  std::set<std::string> names;
  for (const Section& section : kSections) names.insert(section.name);
  app.add_flag("--quick", options.quick,
               "A part of the tour, few peers: for a look, not for a table");
  app.add_option("--only", options.sections, "Only these sections")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  app.add_option("--output", options.output, "Where bench.json and summary.json go")
      ->capture_default_str();
  app.add_option("--config", options.config, "Preset of the modeler")->capture_default_str();
  app.add_option("--limit", options.limit_s, "CPU seconds after which a peer is stopped")
      ->capture_default_str();
  app.add_option("--repetitions", options.repetitions, "Of our whole pipelines")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
}

void run(const Options& options) {
  pin_to_one_core();
  Inputs inputs{options, load_config(eval::find_shared(options.config).string()),
                recording_of(apartment_tour(), options.output)};
  if (options.quick) inputs.tour = head_of(inputs.tour, inputs.tour.lines.size() / 5);
  Report report;
  for (const Section& section : kSections) {
    const bool is_asked_for = options.sections.count(section.name) > 0;
    if (is_asked_for || (options.sections.empty() && section.always))
      section.measure(inputs, report);
  }
  report.write(options.output, !options.sections.empty());
  std::printf("\n%s\nresults in %s\n", report.summary_text().c_str(), options.output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Speed, memory and accuracy, ours beside the packaged peers, in one run"};
  define(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 1;
  }
}
