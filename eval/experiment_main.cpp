// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The paper's experiment without ROS: see `experiment --help`.

#include <cstdio>
#include <exception>
#include <mutex>

#include "eval/experiment.hpp"
#include "eval/experiment_options.hpp"
#include "eval/figure.hpp"
#include "eval/progress_bar.hpp"
#include "eval/share.hpp"
#include "eval/spread.hpp"
#include "eval/sweep.hpp"
#include "modeler/io/atomic_file.hpp"
#include "modeler/io/config_file.hpp"

namespace {

using namespace ribbon_mapper;
using namespace ribbon_mapper::eval;
namespace fs = std::filesystem;

sim::TourConfig tour_config(const ExperimentOptions& options, std::uint64_t seed) {
  sim::TourConfig config;
  config.seed = seed;
  config.hokuyo.noise = sim::range_noise_from(options.noise);
  config.tilt = sim::TiltProfileConfig::preset(options.tilt);
  config.localisation.drift = options.drift;
  return config;
}

/// A world for one thread alone: its contact test is not for several at once, nor is the reader.
sim::World load_world(const ExperimentOptions& options) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return sim::World::load(find_shared(options.world).string(), options.model_paths);
}

/// One run with its files in `directory`.
Summary run_seed(const ExperimentOptions& options, std::uint64_t seed, const fs::path& directory,
                 const ProgressCallback& progress) {
  const ModelerConfig modeler_config = load_config(find_shared(options.config).string());
  const sim::World world = load_world(options);
  const sim::Route route = sim::Route::load(route_path(options).string());
  Results results =
      run_experiment(world, route, tour_config(options, seed), modeler_config, progress);
  results.summary.command = command_of(options, seed);
  results.summary.world = shared_name(find_shared(options.world)).string();
  results.summary.route = shared_name(route_path(options)).string();
  results.summary.seed = seed;
  results.summary.drift = options.drift;
  write_results(results, directory);
  if (options.with_figure) draw_figure(directory);
  return results.summary;
}

void run_one(const ExperimentOptions& options) {
  create_directory_for_files(options.output);  // better now than after the tour
  Summary summary;
  {
    ProgressBar bar;
    summary = run_seed(options, options.seeds.front(), options.output,
                       [&](const Progress& progress) { bar.show(progress); });
  }
  std::printf("%s\nresults in %s\n", summary_table(summary).c_str(), options.output.c_str());
}

void run_many(const ExperimentOptions& options) {
  create_directory_for_files(options.output);
  std::vector<Summary> summaries;
  {
    ProgressBar bar;
    const auto run = [&](std::uint64_t seed, const ProgressCallback& progress) {
      return run_seed(options, seed, options.output / ("seed_" + std::to_string(seed)), progress);
    };
    summaries = run_seeds(options.seeds, options.jobs, run, bar);
  }
  write_file_atomically(options.output / "spread.json", spread_to_json(summaries));
  std::printf("%s\nresults in %s\n", spread_foot(summaries).c_str(), options.output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = parse_experiment_options(argc, argv);
  if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
  try {
    const auto& chosen = std::get<ExperimentOptions>(options);
    chosen.many_seeds ? run_many(chosen) : run_one(chosen);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "experiment: %s\n", error.what());
    return 1;
  }
}
