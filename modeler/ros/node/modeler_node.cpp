// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <utility>

#include "modeler/model_file/autosave.hpp"
#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/model_doubts.hpp"
#include "modeler/ros/intake/tf_feed.hpp"
#include "modeler/ros/intake/time_jump.hpp"
#include "modeler/ros/maps/map_server.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/intake_parameters.hpp"
#include "modeler/ros/node/line_report.hpp"
#include "modeler/ros/node/model_publisher.hpp"
#include "modeler/ros/node/model_services.hpp"
#include "modeler/ros/node/modeler_diagnostics.hpp"
#include "modeler/ros/node/modeler_parameters.hpp"
#include "modeler/ros/node/turn_check.hpp"
#include "modeler/ros/run/run_node.hpp"

namespace ribbon_mapper {
namespace {

constexpr const char* kStopped = "time went back, ~reset is awaited";

/// Runs the modeler on ROS. One thread serves all callbacks; none of them blocks.
class ModelerNode {
 public:
  /// Starts the node. Throws if there is a model to load, and it cannot be.
  explicit ModelerNode(const ModelerParameters& parameters);
  /// Saves what has changed since the last autosave, if it is time, or if the node ends.
  void autosave(bool is_last);

 private:
  void on_scan(const sensor_msgs::LaserScan& scan);
  void on_corrected_trajectory(const nav_msgs::Path& path);
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool on_save(Save::Request& request, Save::Response& response);
  bool on_load(Load::Request& request, Load::Response& response);
  bool on_get_model(GetModel::Request& request, GetModel::Response& response);
  bool on_annotate(Annotate::Request& request, Annotate::Response& response);
  void check_clock();
  void on_time_jump();
  void load_at_start();
  void begin_another_model();
  void empty_model();
  void forget_lines();
  const std::string& map_frame() const { return parameters_.lines.options.frames.map; }
  void take_lines();
  void make_maps_if_wanted();
  void report();
  void warn_of_doubts();

  ModelerParameters parameters_;
  ros::NodeHandle node_, private_node_{"~"};
  ModelKeeper keeper_;
  Autosave autosave_;
  LineIntake intake_;
  ClockGuard clock_;
  AttentiveClock wait_clock_;
  TransformBuffer tf_;
  TfFeed tf_feed_;
  ModelPublisher publisher_;
  MapServer maps_;
  LineReport line_report_;
  ModelerDiagnostics diagnostics_;
  ros::ServiceServer reset_, save_, load_, get_model_, annotate_;
  ros::Subscriber corrected_trajectory_, scan_;
  ros::WallTimer line_timer_, report_timer_;
  BarrenLines barren_lines_;
  bool has_warned_of_no_return_ = false, has_warned_of_timing_ = false;
  bool stopped_ = false;  ///< by a time jump, until ~reset
  TurnCheck turns_;
  std::size_t reports_ = 0, reported_lines_ = 0;
};

ModelerNode::ModelerNode(const ModelerParameters& parameters)
    : parameters_(parameters),
      keeper_(parameters.config),
      autosave_(parameters.output_dir, parameters.autosave_period_s),
      intake_(parameters.lines.options, keeper_.log()),
      tf_(parameters.tf_cache_s, parameters.lines.tf_drop_frames),
      tf_feed_(node_, tf_, [this] { check_clock(); }),
      publisher_(private_node_, parameters.lines.options.frames.map),
      maps_(private_node_, parameters.maps),
      line_report_(keeper_.log(), intake_, tf_, node_.resolveName("scan")),
      diagnostics_(keeper_, line_report_) {
  load_at_start();
  reset_ = private_node_.advertiseService("reset", &ModelerNode::on_reset, this);
  save_ = private_node_.advertiseService("save", &ModelerNode::on_save, this);
  load_ = private_node_.advertiseService("load", &ModelerNode::on_load, this);
  get_model_ = private_node_.advertiseService("get_model", &ModelerNode::on_get_model, this);
  annotate_ = private_node_.advertiseService("annotate", &ModelerNode::on_annotate, this);
  corrected_trajectory_ =
      node_.subscribe("corrected_trajectory", 2, &ModelerNode::on_corrected_trajectory, this);
  // Subscribed last, so that everything is ready for the first line. The queue is long, so that no
  // line is lost during a correction.
  scan_ = node_.subscribe("scan", 5000, &ModelerNode::on_scan, this);
  line_timer_ = node_.createWallTimer(ros::WallDuration(0.02), [this](const ros::WallTimerEvent&) {
    take_lines();
    make_maps_if_wanted();
  });
  report_timer_ = node_.createWallTimer(ros::WallDuration(1.0),
                                        [this](const ros::WallTimerEvent&) { report(); });
}

void ModelerNode::on_scan(const sensor_msgs::LaserScan& scan) {
  check_clock();
  line_report_.saw(scan);
  intake_.add(scan, wait_clock_.now());
  if (stopped_) intake_.restart(kStopped);
  take_lines();
}

void ModelerNode::take_lines() {
  check_clock();
  const Moment now = wait_clock_.now();
  while (const std::optional<ReadyLine> line = intake_.take_next(tf_.core(), now)) {
    keeper_.add(*line);
    turns_.add(line->beams.stamp, line->poses.T_odom_base_first);
  }
}

/// Gives a copy of the model to the thread that makes maps, if somebody asks for one.
void ModelerNode::make_maps_if_wanted() {
  const Modeler& modeler = keeper_.modeler();
  if (!maps_.wants_model(keeper_.version(), modeler.statistics().revision)) return;
  maps_.give(modeler, keeper_.plane_model());
}

void ModelerNode::on_corrected_trajectory(const nav_msgs::Path& path) {
  take_lines();
  try {
    const std::vector<StampedPose> trajectory = trajectory_of(path, map_frame());
    keeper_.correct(trajectory);
    if (const auto text = turns_.contradiction(trajectory))
      ROS_WARN("Corrected, but %s", text->c_str());
  } catch (const std::invalid_argument& error) {
    ROS_ERROR("Corrected trajectory of %zu poses refused: %s. The model stays as it was.",
              path.poses.size(), error.what());
    return;
  }
  ROS_INFO("Corrected by a trajectory of %zu poses in %.0f ms: %zu planes before, %zu now.",
           path.poses.size(), keeper_.correction_ms(), keeper_.before().planes.size(),
           keeper_.planes().size());
  publisher_.publish(keeper_, intake_.done());
}

bool ModelerNode::on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  intake_.restart("reset");
  empty_model();
  stopped_ = false;
  response.success = true;
  response.message = "the model is empty";
  return true;
}

bool ModelerNode::on_save(Save::Request& request, Save::Response& response) {
  response = save_response(request.name, keeper_, parameters_.output_dir, map_frame(),
                           changed_keys(keeper_.modeler().config()), parameters_.mesh_formats);
  if (response.success) {
    ROS_INFO("Saved: %s", response.message.c_str());
  } else {
    ROS_ERROR("Not saved: %s", response.message.c_str());
  }
  return true;
}

bool ModelerNode::on_load(Load::Request& request, Load::Response& response) {
  response = load_response(request.name, keeper_, parameters_.output_dir, map_frame());
  if (!response.success) {
    ROS_ERROR("Not loaded: %s", response.message.c_str());
    return true;
  }
  begin_another_model();
  forget_lines();
  ROS_INFO("Loaded %s", response.message.c_str());
  return true;
}

bool ModelerNode::on_get_model(GetModel::Request& request, GetModel::Response& response) {
  take_lines();
  response = model_response(request, keeper_, map_frame());
  return true;
}

bool ModelerNode::on_annotate(Annotate::Request& request, Annotate::Response& response) {
  take_lines();
  response = annotate_response(request, keeper_);
  if (!response.success) ROS_ERROR("Not annotated: %s", response.message.c_str());
  return true;
}

void ModelerNode::check_clock() {
  if (clock_.went_back()) on_time_jump();
}

/// Separates the runs: lines and transforms of before and after do not fit one trajectory.
void ModelerNode::on_time_jump() {
  tf_.start_next_run();
  intake_.start_next_run("the clock was set back");
  if (parameters_.on_time_jump == OnTimeJump::reset) empty_model();
  stopped_ = parameters_.on_time_jump == OnTimeJump::stop;
  if (stopped_) intake_.restart(kStopped);
  ROS_WARN("Simulated time went back: %s", what_happens_on(parameters_.on_time_jump));
}

void ModelerNode::load_at_start() {
  const auto path =
      file_to_start_from({parameters_.output_dir, parameters_.load, parameters_.resume});
  if (path) {
    ROS_INFO("Loaded %s", load_into(keeper_, load_model_file(*path), *path, map_frame()).c_str());
  }
  if (path != autosave_.file()) begin_another_model();
}

/// Keeps the autosave of the model so far.
void ModelerNode::begin_another_model() {
  try {
    autosave_.begin_another();
  } catch (const std::runtime_error& error) {
    ROS_ERROR("%s", error.what());
  }
}

void ModelerNode::empty_model() {
  begin_another_model();
  keeper_.reset();
  forget_lines();
}

void ModelerNode::autosave(bool is_last) {
  if (keeper_.modeler().ribbons().empty()) return;  // nothing is lost
  const auto bytes = [this] { return keeper_.file_bytes(map_frame()); };
  const std::size_t version = keeper_.version();
  const std::string error = is_last
                                ? autosave_.finish(version, bytes)
                                : autosave_.offer(version, ros::SteadyTime::now().toSec(), bytes);
  if (!error.empty()) ROS_ERROR("No autosave: %s", error.c_str());
}

/// Forgets what is known of the lines so far.
void ModelerNode::forget_lines() {
  turns_.clear();
  line_report_.restart();
  barren_lines_ = {};
  reported_lines_ = 0;
}

void ModelerNode::report() {
  publisher_.publish(keeper_, intake_.done());
  diagnostics_.publish();
  autosave(false);
  if (++reports_ % 5 != 0) return;  // counted, not throttled: simulated time may stand still
  line_report_.warn();
  warn_of_doubts();
  const std::string complaint = line_report_.complaint();
  if (!complaint.empty()) {
    ROS_WARN("%s", complaint.c_str());
  } else if (std::exchange(reported_lines_, keeper_.log().lines()) != keeper_.log().lines()) {
    ROS_INFO("%zu lines (%zu dropped), %zu ribbons, %.0f times real time", keeper_.log().lines(),
             keeper_.log().dropped_lines(), keeper_.modeler().statistics().ribbons,
             keeper_.real_time_factor());
  }
}

void ModelerNode::warn_of_doubts() {
  const std::string complaint = barren_lines_.complaint(keeper_.log());
  if (!complaint.empty()) ROS_WARN("%s", complaint.c_str());
  const auto no_return = keeper_.modeler().statistics().no_return;
  if (no_return && !std::exchange(has_warned_of_no_return_, true)) {
    ROS_WARN("%s.", no_return_text(*no_return).c_str());
  }
  const std::string timing = keeper_.log().timing_doubt();
  if (!timing.empty() && !std::exchange(has_warned_of_timing_, true)) {
    ROS_WARN("%s.", timing.c_str());
  }
}

}  // namespace
}  // namespace ribbon_mapper

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{"modeler", "builds planes from the lines of a laser",
                                     "modeler.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    ribbon_mapper::ModelerNode node(ribbon_mapper::modeler_parameters());
    ros::spin();
    node.autosave(true);
    return 0;
  });
}
