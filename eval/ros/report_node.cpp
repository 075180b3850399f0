// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <stdexcept>

#include "eval/results/trajectory_error.hpp"
#include "eval/results/world_outlines.hpp"
#include "eval/ros/tour_watch.hpp"
#include "modeler/io/config_file.hpp"
#include "modeler/program/figure.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/ros/node/strict_parameters.hpp"
#include "modeler/ros/run/run_node.hpp"
#include "modeler/storage/file_set.hpp"
#include "sim/sdf/resource_finder.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr double kProgressPeriod_s = 5.0;

/// Returns what corrected the trajectory. Throws std::invalid_argument that lists what is allowed.
std::string closure_from(const std::string& name) {
  if (name == "truth" || name == "self") return name;
  throw std::invalid_argument("parameter closure is '" + name + "', allowed are truth and self");
}

/// Returns the error of an estimated trajectory; nothing if it lacks poses or the truth does.
std::optional<EstimateSummary> estimate_of(const Results& results) {
  const std::vector<StampedPose>& estimate = results.trajectory_after;
  if (estimate.empty() || estimate.size() != results.trajectory_truth.size()) return std::nullopt;
  return EstimateSummary{trajectory_error(estimate, results.trajectory_truth), std::nullopt};
}

struct NodeParameters {
  std::filesystem::path output;
  std::string world, model_path;
  SurfaceConfig surface;  ///< of the modeler's preset
  bool visuals;
  double timeout_s;
  Summary summary;  ///< conditions of the run, from the launch file

  static NodeParameters read() {
    StrictParameters from;
    NodeParameters p;
    p.output = std::filesystem::absolute(from.required_text("output", "a folder for the results"));
    p.world = from.text("world", "");
    p.model_path = from.text("model_path", "");
    p.visuals = from.flag("visuals", false);
    p.timeout_s = from.number("timeout", 120.0, 1.0, 1e6);
    RunOptions& run = p.summary.run;
    run.world = portable_name(p.world).string();
    run.route = portable_name(from.text("route", "")).string();
    const std::string config = from.text("config", "");
    if (!config.empty()) p.surface = load_config(find_installed_file(config).string()).surface;
    run.config = portable_name(config).string();
    run.noise = run.tilt = run.caster = "";  // known to the simulator only
    run.seed = static_cast<std::uint64_t>(from.integer("seed", 0, 0, 2'000'000'000));
    run.drift = from.number("drift", 0.0, 0.0, 1000.0);
    run.closure = closure_from(from.text("closure", "truth"));
    p.summary.command = from.text("command", "");
    from.refuse_unknown();
    return p;
  }
};

/// Returns the outlines of the world for the figure, or none with a warning if it cannot be loaded.
std::vector<std::vector<Eigen::Vector2d>> outlines_of(const NodeParameters& parameters) {
  if (parameters.world.empty()) return {};
  std::string model_path = parameters.model_path;
  if (const char* list = std::getenv("GAZEBO_MODEL_PATH")) model_path += ":" + std::string(list);
  try {
    return world_outlines(sim::World::load(parameters.world, sim::split_path_list(model_path),
                                           sim::RayCasterKind::bullet, parameters.visuals));
  } catch (const std::runtime_error& error) {
    ROS_WARN("The figure will not show the world: %s", error.what());
    return {};
  }
}

/// Waits for the end of a tour and for its correction, then compares the models with the truth.
class ReportNode {
 public:
  explicit ReportNode(const NodeParameters& parameters) : parameters_(parameters) {
    create_directory_for_files(parameters.output);  // fails before the tour rather than after it
    timer_ = node_.createWallTimer(ros::WallDuration(1.0),
                                   [this](const ros::WallTimerEvent&) { tick(); });
  }

  /// Spins until the results are written. Returns the exit code; throws if they cannot be made.
  int run() {
    ros::spin();
    if (failure_) std::rethrow_exception(failure_);
    return is_done_ ? 0 : 1;
  }

 private:
  void tick() {
    try {
      watch_.look();
      const std::string missing = watch_.missing();
      if (missing.empty()) return write();
      if (watch_.idle_s() > parameters_.timeout_s) fail_for_lack_of(missing);
      show_progress();
    } catch (...) {
      failure_ = std::current_exception();
      ros::shutdown();
    }
  }

  void show_progress() {
    const ros::WallTime now = ros::WallTime::now();
    if ((now - last_progress_).toSec() < kProgressPeriod_s) return;
    last_progress_ = now;
    ROS_INFO("%s", watch_.tour_finished() ? ("waiting for " + watch_.missing()).c_str()
                                          : watch_.progress().c_str());
  }

  [[noreturn]] void fail_for_lack_of(const std::string& missing) {
    throw std::runtime_error("No results: " + std::to_string(static_cast<int>(watch_.idle_s())) +
                             " s without a new line or correction, still waiting for " + missing +
                             ". The wait is set by ~timeout.");
  }

  void write() {
    Results results = watch_.results(parameters_.surface);
    Summary& summary = results.summary;
    summary.command = parameters_.summary.command;
    summary.run = parameters_.summary.run;
    results.world_outlines = outlines_of(parameters_);
    evaluate(results);
    if (summary.run.closure == "self") summary.estimate = estimate_of(results);
    FileSet files = staged_results(results, parameters_.output);
    draw_figure(Figure::before_after, files.folder(), parameters_.output);
    files.commit();
    std::printf("\n%s", summary_table(summary).c_str());
    std::printf("\nresults in %s\n", parameters_.output.c_str());
    std::fflush(stdout);
    is_done_ = true;
    ros::shutdown();
  }

  NodeParameters parameters_;
  ros::NodeHandle node_;
  TourWatch watch_;
  ros::WallTimer timer_;
  ros::WallTime last_progress_ = ros::WallTime::now();
  std::exception_ptr failure_;
  bool is_done_ = false;
};

}  // namespace
}  // namespace ribbon_mapper::eval

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{
      "report", "compares the models of a simulated tour with its world", "loop_closure.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    return ribbon_mapper::run_program("report", [] {  // rosconsole may be down at its end
      return ribbon_mapper::eval::ReportNode(ribbon_mapper::eval::NodeParameters::read()).run();
    });
  });
}
