// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/run.hpp"

#include <mutex>

#include "modeler/io/config_file.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/report/changed_keys.hpp"

namespace ribbon_mapper::eval {
namespace {

Closure closure_of(const RunOptions& run) {
  if (run.closure != "self") return Closure::truth;
  return run.base_laser ? Closure::self_with_base_laser : Closure::self;
}

}  // namespace

sim::TourConfig tour_config(const RunOptions& run) {
  sim::TourConfig config;
  config.seed = run.seed;
  config.hokuyo.noise = sim::range_noise_from(run.noise);
  config.tilt = sim::TiltProfileConfig::preset(run.tilt);
  config.localisation.drift = run.drift;
  config.localisation.faults = sim::OdometryFaults::from(run.odometry_faults);
  if (run.beams) config.hokuyo.set_beams(*run.beams);
  if (run.rate_hz) config.hokuyo.rate_hz = *run.rate_hz;
  return config;
}

ModelerConfig modeler_config(const RunOptions& run) {
  ModelerConfig config = load_config(find_installed_file(run.config).string());
  if (run.deskew) config.scan.deskew = *run.deskew;
  return config;
}

// Neither Bullet's contact test nor the SDF reader is thread-safe, hence the lock and a world for
// each run.
sim::World load_world(const RunOptions& run) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return sim::World::load(find_installed_file(run.world).string(), run.model_paths,
                          sim::ray_caster_kind_from(run.caster), run.visuals);
}

sim::Route load_route(const RunOptions& run) {
  const sim::Route route = sim::Route::load(route_path(run).string());
  return run.speed_m_s ? route.at_speed(*run.speed_m_s) : route;
}

std::string world_text(const RunOptions& run) {
  const sim::World world = load_world(run);
  const sim::Tour tour(world, load_route(run), tour_config(run));
  std::string text = world.content() + "; " + tour.view() + "\n";
  for (const std::string& warning : world.warnings())
    text += "warning: world " + run.world + ": " + warning + "\n";
  return text;
}

Results make_run(const RunOptions& run, const ProgressCallback& progress) {
  const ModelerConfig config = modeler_config(run);
  const sim::World world = load_world(run);
  Results results =
      run_experiment(world, load_route(run), tour_config(run), config, closure_of(run), progress);
  results.summary.run = with_portable_names(run);
  results.summary.command = command_of(run);
  results.parameters = changed_keys(config);
  return results;
}

}  // namespace ribbon_mapper::eval
