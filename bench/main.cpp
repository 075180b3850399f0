// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares our speed, memory and accuracy with those of packaged alternatives; see `bench --help`.

#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <utility>

#include "bench/recording/bag_recording.hpp"
#include "bench/recording/tour_recording.hpp"
#include "bench/sections.hpp"
#include "modeler/io/config_file.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/ros/bag_check/bag_check_options.hpp"

namespace {

using namespace ribbon_mapper;
using namespace ribbon_mapper::bench;

/// A section of the report.
struct Section {
  const char* name;
  void (*measure)(const Inputs&, Report&);
  bool always = true;  ///< runs even if it is not named
};
constexpr Section kSections[] = {{"normals", measure_normals},
                                 {"lines", measure_lines},
                                 {"planes", measure_planes},
                                 {"corrections", measure_corrections},
                                 {"maps", measure_maps},
                                 {"memory", measure_memory},
                                 {"rays", measure_rays},
                                 {"growth", measure_growth},
                                 {"profile", run_for_profile, false}};

constexpr const char* kBags = "bag";  // name of the section on recordings

/// Pins the process to one core, so that no peer can use several.
void pin_to_one_core() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &cores);
  sched_setaffinity(0, sizeof cores, &cores);
}

void define_bags(CLI::App& app, Options& options, std::string& tf_drop_frames) {
  app.add_option(
      "--bag", options.bags,
      "Bags to measure as well, each in its own section \"bag\". Ratios are named bag_* for the "
      "first one, bag_NAME_* for others. There is no ground truth; recorded poses count as true");
  app.add_option("--bag-config", options.bag_configs,
                 "Presets of the bags, in the same order [that of --config]");
  add_bag_options(app, options.bag, tf_drop_frames);
}

void define(CLI::App& app, Options& options) {
  std::set<std::string> names{kBags};
  for (const Section& section : kSections) names.insert(section.name);
  app.add_flag("--quick", options.quick,
               "Use a part of each recording and few peers; the figures are not representative");
  app.add_option("--only", options.sections, "Run only these sections")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  app.add_option("--output", options.output, "Folder for bench.json, summary.json and cached tours")
      ->capture_default_str();
  app.add_option("--config", options.config, "Preset of the modeler")->capture_default_str();
  app.add_option("--limit", options.limit_s, "CPU time after which a peer is stopped [s]")
      ->capture_default_str();
  app.add_option("--repetitions", options.repetitions, "Repetitions of our pipelines")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
}

/// Keeps a fifth of a recording, but at least 1000 lines.
void shorten(Recording& recording) {
  const std::size_t lines = recording.lines.size();
  recording = head_of(recording, std::max(lines / 5, std::min<std::size_t>(lines, 1000)));
}

Inputs inputs_of(const Options& options, const std::string& config, Recording recording) {
  if (options.quick) shorten(recording);
  return {options, load_config(find_installed_file(config).string()), std::move(recording)};
}

std::vector<Inputs> bags_of(const Options& options) {
  if (options.bag_configs.size() > options.bags.size()) {
    throw std::runtime_error(
        "there are more --bag-config than --bag: give at most one for each bag");
  }
  if (options.bags.empty() && options.sections.count(kBags) > 0) {
    throw std::runtime_error("--only bag needs a bag: add --bag FILE");
  }
  std::vector<Inputs> bags;
  for (std::size_t i = 0; i < options.bags.size(); ++i) {
    const bool has_config = i < options.bag_configs.size();
    bags.push_back(inputs_of(options, has_config ? options.bag_configs[i] : options.config,
                             recording_of_bag(options.bags[i], options.bag)));
    require_ribbons(bags.back());
  }
  return bags;
}

void run(const Options& options) {
  pin_to_one_core();
  const std::vector<Inputs> bags = bags_of(options);  // first, as a faulty bag ends the program
  const Inputs tour =
      inputs_of(options, options.config, recording_of(apartment_tour(), options.output));
  Report report;
  for (const Section& section : kSections) {
    if (options.asks_for(section.name, section.always)) section.measure(tour, report);
  }
  if (options.asks_for(kBags, true)) measure_bags(bags, report);
  report.write(options.output, !options.sections.empty());
  std::printf("\n%s\nresults in %s\n", report.summary_text().c_str(), options.output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Measures our speed, memory and accuracy and those of packaged peers in one run"};
  std::string tf_drop_frames;
  define(app, options);
  define_bags(app, options, tf_drop_frames);
  CLI11_PARSE(app, argc, argv);
  finish_bag_options(options.bag, tf_drop_frames);
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 1;
  }
}
