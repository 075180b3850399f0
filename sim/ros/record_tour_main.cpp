// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records a simulated tour as a bag, without a master: see `record_tour --help`.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "modeler/io/tum.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/program/interrupt.hpp"
#include "modeler/program/progress_bar.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/program/version.hpp"
#include "modeler/storage/atomic_file.hpp"
#include "sim/ros/tour_recorder.hpp"
#include "sim/sdf/resource_finder.hpp"

namespace {

using namespace ribbon_mapper;

struct Options {
  std::string world, route, bag, truth;
  std::string noise = "datasheet", tilt = "manip", caster = "bullet", odometry_faults;
  std::vector<std::string> model_paths;
  bool visuals = false;
  int beams = 0;
  double keyframe_step_m = 0.0, speed_m_s = 0.0;
  sim::TourConfig tour;
  sim::RecorderOptions recorder;
};

std::string installed(const std::string& path) { return find_installed_file(path).string(); }

/// Returns the path of the route.
std::string route_path(const Options& options) {
  if (!options.route.empty()) return options.route;
  return std::filesystem::path(options.world).replace_extension(".route.yaml").string();
}

void add_file_options(CLI::App& app, Options& options) {
  app.add_option("--world", options.world, "world (SDF file)")
      ->required()
      ->transform(installed)
      ->check(CLI::ExistingFile);
  app.add_option("--route", options.route, "route file [<world>.route.yaml, beside the world]")
      ->transform(installed);
  app.add_option("--model-path", options.model_paths,
                 "folder for model:// URIs, searched before GAZEBO_MODEL_PATH; may be repeated");
  app.add_flag("--visuals", options.visuals, "take models without collision from their visuals");
  app.add_option("--bag", options.bag, "bag to write")->required();
  app.add_option("--seconds", options.recorder.longest_s,
                 "length of the recording from the start of the tour [s]")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--truth", options.truth, "file for the true poses of the base (TUM)");
  app.add_option("--keyframes", options.keyframe_step_m,
                 "write a true pose only every so many metres")
      ->check(CLI::Range(0.0, 1000.0));
}

void add_laser_options(CLI::App& app, Options& options) {
  app.add_option("--noise", options.noise,
                 "range noise of the laser: datasheet, gazebo, pomerleau or none")
      ->capture_default_str();
  app.add_option("--beams", options.beams, "number of beams, 0.25 degrees apart [the PR2's 381]")
      ->check(CLI::Range(3, 1081));
  app.add_option("--rate", options.tour.hokuyo.rate_hz, "scans per second")
      ->check(CLI::Range(1.0, 40.0))
      ->capture_default_str();
  app.add_option("--tilt", options.tilt, "profile of the tilt: manip, nav or slow")
      ->capture_default_str();
  app.add_option("--stamp-error", options.recorder.stamp_error_s,
                 "constant error of the scans' stamps [s]")
      ->check(CLI::Range(-1.0, 1.0))
      ->capture_default_str();
  app.add_flag("--base-laser", options.recorder.base_laser,
               "also record base_scan, the laser on the base; casts 3.7 times as many rays");
  app.add_option("--caster", options.caster, "library that casts the rays: bullet or embree")
      ->capture_default_str();
}

void add_robot_options(CLI::App& app, Options& options) {
  app.add_option("--speed", options.speed_m_s,
                 "speed of the robot [m/s]; scales the turn rate alike [the route's]")
      ->check(CLI::Range(0.01, 1.0));
  app.add_option("--drift", options.tour.localisation.drift, "scale of the localisation noise")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  app.add_option("--odometry-faults", options.odometry_faults,
                 "slip=T:DEGREES, shift=T:METRES, push=T:SECONDS, scale=X, yaw_scale=X, "
                 "separated by commas");
  app.add_option("--seed", options.tour.seed, "seed of all noise")->capture_default_str();
}

void run(Options& options) {
  options.tour.tilt = sim::TiltProfileConfig::preset(options.tilt);
  options.tour.hokuyo.noise = sim::range_noise_from(options.noise);
  if (options.beams > 0) options.tour.hokuyo.set_beams(options.beams);
  options.tour.localisation.faults = sim::OdometryFaults::from(options.odometry_faults);
  sim::add_gazebo_paths(options.model_paths);
  const sim::World world =
      sim::World::load(options.world, options.model_paths,
                       sim::ray_caster_kind_from(options.caster), options.visuals);
  sim::Route route = sim::Route::load(route_path(options));
  if (options.speed_m_s > 0.0) route = route.at_speed(options.speed_m_s);
  sim::Tour tour(world, route, options.tour);
  std::fprintf(stderr, "%s; %s\n", world.content().c_str(), tour.view().c_str());
  for (const std::string& warning : world.warnings())
    std::fprintf(stderr, "warning: world %s: %s\n", options.world.c_str(), warning.c_str());
  std::vector<StampedPose> truth;
  std::size_t recorded = 0;
  try {
    ProgressBar bar;
    truth = sim::record_tour(tour, options.recorder, options.bag, [&](std::size_t lines) {
      recorded = lines;
      bar.show({lines, tour.line_count()});
      stop_if_interrupted();
    });
  } catch (const Interrupted&) {
    throw Interrupted("interrupted, " + std::to_string(recorded) + " of " +
                      std::to_string(tour.line_count()) + " lines are in " + options.bag);
  }
  std::printf("%zu lines in %s\n", truth.size(), options.bag.c_str());
  if (options.truth.empty()) return;
  if (options.keyframe_step_m > 0.0) truth = sim::keyframes(truth, options.keyframe_step_m);
  write_file_atomically(options.truth, to_tum(truth));
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("record_tour", [&] {
    Options options;
    CLI::App app("Records a simulated tour as a bag, as the robot would.", "record_tour");
    app.set_version_flag("--version", version());
    add_file_options(app, options);
    add_laser_options(app, options);
    add_robot_options(app, options);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? 0 : 2;
    }
    watch_interrupts();
    run(options);
    return 0;
  });
}
