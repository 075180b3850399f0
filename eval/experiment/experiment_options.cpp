// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/experiment_options.hpp"

#include <CLI/CLI.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "modeler/exports/export_options.hpp"
#include "modeler/program/version.hpp"
#include "sim/rays/ray_caster.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/robot/tilt_profile.hpp"
#include "sim/sdf/resource_finder.hpp"
#include "sim/tour/odometry_faults.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr std::size_t kMaxSeeds = 100'000;

constexpr const char* kDescription =
    "Drives a simulated PR2 through a world, maps the scans of its tilting laser with noisy "
    "poses,\n"
    "corrects the trajectory at the end and compares the planes with the ground truth.\n"
    "Without options it runs the apartment with seed 1 and writes results/experiment.\n"
    "Several seeds, or lists such as --drift 0,1,2, make a series of runs with all combinations.\n"
    "Each run adds a line to <output>/runs.jsonl; runs that are in it are not repeated.";

constexpr const char* kFooter =
    "Worlds, routes and presets are searched in the current folder, then in the package.\n"
    "Exit codes: 0 success, 1 failure, 2 wrong usage, 130 interrupted.";

/// Lists as given on the command line; a series runs all their combinations.
struct Lists {
  std::vector<std::string> worlds{RunOptions().world}, noises{RunOptions().noise},
      tilts{RunOptions().tilt}, deskews;
  std::vector<double> drifts{RunOptions().drift}, rates_hz, speeds_m_s;
  std::vector<int> beams;
  std::uint64_t seed = RunOptions().seed;
  std::string seeds;
  bool no_figure = false;
};

/// Returns a check of a number's range. CLI11's own accepts NaN.
auto number_within(double least, double most) {
  return [=](const std::string& text) {
    double number = 0.0;
    if (CLI::detail::lexical_cast(text, number) && number >= least && number <= most) return;
    std::ostringstream message;
    message << "'" << text << "' is not a number from " << least << " to " << most;
    throw std::invalid_argument(message.str());
  };
}

/// Checks a seed. CLI11 would convert -1 to a very large number.
void require_seed(const std::string& text) {
  const bool is_whole = text.find_first_not_of("0123456789") == std::string::npos;
  if (is_whole && !text.empty() && text.size() <= 18) return;
  throw std::invalid_argument("'" + text + "' is not an integer from 0 on");
}

void add_run_options(CLI::App& app, RunOptions& run) {
  app.add_option("--route", run.route, "route file [<world>.route.yaml, beside the world]");
  app.add_option("--config", run.config, "preset of the modeler")->capture_default_str();
  app.add_option("--closure", run.closure, "what corrects the trajectory: truth or self")
      ->check(CLI::IsMember({"truth", "self"}))
      ->capture_default_str();
  app.add_flag("--base-laser", run.base_laser,
               "--closure self uses the laser on the base, too; casts 3.7 times as many rays");
  app.add_option("--odometry-faults", run.odometry_faults,
                 "slip=T:DEGREES, shift=T:METRES, push=T:SECONDS, scale=X, yaw_scale=X, "
                 "separated by commas")
      ->check(accepted_by(sim::OdometryFaults::from));
  app.add_option("--caster", run.caster, "library that casts the laser's rays: bullet or embree")
      ->check(accepted_by(sim::ray_caster_kind_from))
      ->capture_default_str();
  app.add_flag("--visuals", run.visuals, "take models without collision from their visuals");
  app.add_option("--model-path", run.model_paths,
                 "folder for model:// URIs, searched before GAZEBO_MODEL_PATH; may be repeated");
}

template <typename Value>
CLI::Option* add_list(CLI::App& app, const char* name, std::vector<Value>& values,
                      const char* meaning) {
  return app.add_option(name, values, meaning)->delimiter(',')->allow_extra_args(false);
}

void add_list_options(CLI::App& app, Lists& lists) {
  app.option_defaults()->group("Options that take lists (a,b,c): a series runs all combinations");
  add_list(app, "--world", lists.worlds, "SDF world file")->capture_default_str();
  add_list(app, "--drift", lists.drifts, "scale of the localisation noise; 1 is gmapping's")
      ->check(accepted_by(number_within(0.0, 1000.0)))
      ->capture_default_str();
  add_list(app, "--noise", lists.noises,
           "range noise of the laser: datasheet, gazebo, pomerleau or none")
      ->check(accepted_by(sim::range_noise_from))
      ->capture_default_str();
  add_list(app, "--tilt", lists.tilts, "tilt profile of the laser: manip, nav or slow")
      ->check(accepted_by(sim::TiltProfileConfig::preset))
      ->capture_default_str();
  add_list(app, "--beams", lists.beams,
           "number of beams, 0.25 degrees apart: 3 to 1081 [the PR2's 381]")
      ->check(CLI::Range(3, 1081).description(""));
  add_list(app, "--rate", lists.rates_hz, "scans per second: 1 to 40 [the PR2's 40]")
      ->check(accepted_by(number_within(1.0, 40.0)));
  add_list(app, "--speed", lists.speeds_m_s,
           "speed of the robot, 0.01 to 1 m/s; scales the turn rate alike [the route's]")
      ->check(accepted_by(number_within(0.01, 1.0)));
  add_list(app, "--deskew", lists.deskews,
           "place each beam at its own time: on or off [the preset's]")
      ->check(CLI::IsMember({"on", "off"}).description(""));
  app.option_defaults()->group("Options");
  auto* seed = app.add_option("--seed", lists.seed, "seed of all noise")
                   ->check(accepted_by(require_seed))
                   ->capture_default_str();
  app.add_option("--seeds", lists.seeds, "several seeds, such as 1-20 or 1,3,5")
      ->check(accepted_by(seeds_from))
      ->excludes(seed);
}

void add_output_options(CLI::App& app, ExperimentOptions& options, bool& no_figure) {
  app.add_option("--output", options.output, "folder for the results")->capture_default_str();
  app.add_option("--jobs", options.jobs,
                 "number of runs at a time; measured times are exact only with 1")
      ->check(CLI::Range(1, 256).description(""))
      ->capture_default_str();
  app.add_flag("--no-figure", no_figure, "draw no figure");
  add_export_options(app, options.with_floor_plan, options.mesh_formats);
  app.add_flag("--line", options.line_only,
               "print the lines of runs.jsonl and write no files, for runs on several machines");
  app.add_flag(
      "--calibrate", options.calibrate,
      "learn V_sensor, V_slam and the tolerances in front of a known plane, write a preset");
}

/// Replaces each run by one run per value. Without values, leaves the runs unchanged.
template <typename Value, typename Set>
void combine(std::vector<RunOptions>& runs, const std::vector<Value>& values, const Set& set) {
  if (values.empty()) return;
  std::vector<RunOptions> combined;
  for (const RunOptions& run : runs) {
    for (const Value& value : values) set(combined.emplace_back(run), value);
  }
  runs = std::move(combined);
}

std::vector<RunOptions> combinations(const Lists& lists, const RunOptions& common) {
  std::vector<RunOptions> runs{common};
  const auto seeds = lists.seeds.empty() ? std::vector{lists.seed} : seeds_from(lists.seeds);
  combine(runs, lists.worlds, [](RunOptions& run, const auto& v) { run.world = v; });
  combine(runs, lists.noises, [](RunOptions& run, const auto& v) { run.noise = v; });
  combine(runs, lists.tilts, [](RunOptions& run, const auto& v) { run.tilt = v; });
  combine(runs, lists.beams, [](RunOptions& run, int v) { run.beams = v; });
  combine(runs, lists.rates_hz, [](RunOptions& run, double v) { run.rate_hz = v; });
  combine(runs, lists.speeds_m_s, [](RunOptions& run, double v) { run.speed_m_s = v; });
  combine(runs, lists.deskews, [](RunOptions& run, const auto& v) { run.deskew = v == "on"; });
  combine(runs, lists.drifts, [](RunOptions& run, double v) { run.drift = v; });
  combine(runs, seeds, [](RunOptions& run, std::uint64_t v) { run.seed = v; });
  return runs;
}

/// Checks options against each other.
void require_fitting(const Lists& lists, const RunOptions& common) {
  if (common.base_laser && common.closure != "self") {
    throw CLI::ValidationError("--base-laser", "only the estimate uses it: add --closure self");
  }
  if (lists.worlds.size() > 1 && !common.route.empty()) {
    throw CLI::ValidationError("--route", "one route does not fit several worlds: leave it out");
  }
}

std::string joined(int argc, const char* const* argv) {
  std::string command = "rosrun ribbon_mapper experiment";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

}  // namespace

std::variant<ExperimentOptions, int> parse_experiment_options(int argc, const char* const* argv) {
  ExperimentOptions options;
  Lists lists;
  RunOptions common;
  CLI::App app(kDescription, "experiment");
  app.set_version_flag("--version", version());
  app.footer(kFooter);
  add_list_options(app, lists);
  add_run_options(app, common);
  add_output_options(app, options, lists.no_figure);
  try {
    app.parse(argc, argv);
    require_fitting(lists, common);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  sim::add_gazebo_paths(common.model_paths);
  options.runs = combinations(lists, common);
  options.is_series = !lists.seeds.empty() || options.runs.size() > 1;
  options.with_figure = !lists.no_figure;
  options.command = joined(argc, argv);
  return options;
}

std::vector<std::uint64_t> seeds_from(const std::string& list) {
  static const std::regex kForm(R"((\d{1,18})(?:(?:-|\.\.)(\d{1,18}))?)");
  std::set<std::uint64_t> seeds;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');) {
    std::smatch match;
    const bool is_well_formed = std::regex_match(part, match, kForm);
    const std::uint64_t first = is_well_formed ? std::stoull(match[1]) : 1;
    const std::uint64_t last = is_well_formed && match[2].matched ? std::stoull(match[2]) : first;
    if (!is_well_formed || last < first || last - first >= kMaxSeeds) {
      throw std::invalid_argument("seeds: '" + part + "' is not a number or a range such as 1-20");
    }
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.insert(seed);
  }
  if (seeds.empty()) throw std::invalid_argument("seeds: none given; for example 1-20 or 1,3,5");
  return {seeds.begin(), seeds.end()};
}

}  // namespace ribbon_mapper::eval
