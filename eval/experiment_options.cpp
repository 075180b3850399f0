// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_options.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iomanip>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "eval/share.hpp"
#include "sim/hokuyo.hpp"
#include "sim/resource_finder.hpp"
#include "sim/tilt_profile.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr std::size_t kMostSeeds = 100'000;

constexpr const char* kDescription =
    "Drives a simulated PR2 through a world, models what its tilting laser sees with noisy poses,\n"
    "corrects the trajectory at the end and measures the planes against the truth.\n"
    "Without any option: the apartment, seed 1, into results/experiment.";

constexpr const char* kFooter =
    "A world, route or preset that is not in the current folder is looked for in the package.\n"
    "Exit code: 0 done, 1 the experiment could not be done, 2 wrong usage.";

/// A check that says what `parse` throws.
template <typename Parse>
CLI::Validator accepted_by(Parse parse) {
  return CLI::Validator(
      [parse](const std::string& text) -> std::string {
        try {
          parse(text);
          return "";
        } catch (const std::invalid_argument& error) {
          return error.what();
        }
      },
      "");
}

/// CLI11's own range lets nan through.
void require_drift(const std::string& text) {
  double drift = -1.0;
  if (CLI::detail::lexical_cast(text, drift) && drift >= 0.0 && drift <= 1000.0) return;
  throw std::invalid_argument("'" + text + "' is not a number from 0 to 1000");
}

/// CLI11 takes -1 for a very large number.
void require_seed(const std::string& text) {
  const bool is_whole = text.find_first_not_of("0123456789") == std::string::npos;
  if (is_whole && !text.empty() && text.size() <= 18) return;
  throw std::invalid_argument("'" + text + "' is not a whole number from 0 on");
}

void add_run_options(CLI::App& app, ExperimentOptions& options) {
  app.add_option("--world", options.world, "SDF world")->capture_default_str();
  app.add_option("--route", options.route, "route [<world>.route.yaml, beside the world]");
  app.add_option("--drift", options.drift, "scale of the localisation noise, 1: gmapping's")
      ->check(accepted_by(require_drift))
      ->capture_default_str();
  app.add_option("--config", options.config, "preset of the modeler")->capture_default_str();
  app.add_option("--model-path", options.model_paths,
                 "folder for model:// URIs, before GAZEBO_MODEL_PATH; may be repeated");
  app.add_option("--noise", options.noise, "of the laser: datasheet, gazebo, pomerleau or none")
      ->check(accepted_by(sim::range_noise_from))
      ->capture_default_str();
  app.add_option("--tilt", options.tilt, "of the laser: manip, nav or slow")
      ->check(accepted_by(sim::TiltProfileConfig::preset))
      ->capture_default_str();
}

void add_output_options(CLI::App& app, ExperimentOptions& options, bool& no_figure) {
  app.add_option("--output", options.output, "folder for the results")->capture_default_str();
  app.add_option("--jobs", options.jobs, "seeds at a time; times are exact only with 1")
      ->check(CLI::Range(1, 256).description(""))
      ->capture_default_str();
  app.add_flag("--no-figure", no_figure, "do not draw before_after.svg and .png");
}

/// Folders of the environment come after those of the command line.
void add_gazebo_paths(std::vector<std::string>& model_paths) {
  const char* list = std::getenv("GAZEBO_MODEL_PATH");
  if (list == nullptr) return;
  for (const std::string& path : sim::split_path_list(list)) model_paths.push_back(path);
}

}  // namespace

std::variant<ExperimentOptions, int> parse_experiment_options(int argc, const char* const* argv) {
  ExperimentOptions options;
  std::string seeds;
  bool no_figure = false;
  CLI::App app(kDescription, "experiment");
  app.footer(kFooter);
  add_run_options(app, options);
  auto* seed = app.add_option("--seed", options.seeds.front(), "of all noise")
                   ->check(accepted_by(require_seed))
                   ->capture_default_str();
  app.add_option("--seeds", seeds, "several, such as 1-20 or 1,3,5: one folder each, and medians")
      ->check(accepted_by(seeds_from))
      ->excludes(seed);
  add_output_options(app, options, no_figure);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  options.many_seeds = !seeds.empty();
  if (options.many_seeds) options.seeds = seeds_from(seeds);
  options.with_figure = !no_figure;
  add_gazebo_paths(options.model_paths);
  return options;
}

std::vector<std::uint64_t> seeds_from(const std::string& list) {
  static const std::regex form(R"((\d{1,18})(?:(?:-|\.\.)(\d{1,18}))?)");
  std::set<std::uint64_t> seeds;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');) {
    std::smatch match;
    const bool is_well_formed = std::regex_match(part, match, form);
    const std::uint64_t first = is_well_formed ? std::stoull(match[1]) : 1;
    const std::uint64_t last = is_well_formed && match[2].matched ? std::stoull(match[2]) : first;
    if (!is_well_formed || last < first || last - first >= kMostSeeds) {
      throw std::invalid_argument("seeds: '" + part + "' is not a number or a range such as 1-20");
    }
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.insert(seed);
  }
  if (seeds.empty()) throw std::invalid_argument("seeds: none given; for example 1-20 or 1,3,5");
  return {seeds.begin(), seeds.end()};
}

std::filesystem::path route_path(const ExperimentOptions& options) {
  if (!options.route.empty()) return find_shared(options.route);
  return find_shared(options.world).replace_extension(".route.yaml");
}

std::string command_of(const ExperimentOptions& options, std::uint64_t seed) {
  const ExperimentOptions defaults;
  std::ostringstream command;
  command << "rosrun ribbon_mapper experiment";
  const auto add = [&](const char* name, const auto& value, const auto& unless) {
    if (value != unless) command << " " << name << " " << value;
  };
  const auto quoted = [](const std::string& text) {
    return text.find_first_of(" \t'\"$&;()*?") == std::string::npos ? text : "'" + text + "'";
  };
  command << " --world " << quoted(shared_name(options.world).string());
  add("--route", quoted(options.route), quoted(defaults.route));
  command << " --seed " << seed << " --drift " << options.drift;
  add("--config", quoted(options.config), quoted(defaults.config));
  add("--noise", options.noise, defaults.noise);
  add("--tilt", options.tilt, defaults.tilt);
  for (const std::string& path : options.model_paths) command << " --model-path " << quoted(path);
  return command.str();
}

}  // namespace ribbon_mapper::eval
