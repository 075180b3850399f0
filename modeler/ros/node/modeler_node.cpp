// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <utility>

#include "modeler/io/config_file.hpp"
#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/model_doubts.hpp"
#include "modeler/ros/intake/tf_feed.hpp"
#include "modeler/ros/intake/time_jump.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/intake_parameters.hpp"
#include "modeler/ros/node/line_report.hpp"
#include "modeler/ros/node/model_publisher.hpp"
#include "modeler/ros/node/model_services.hpp"
#include "modeler/ros/node/modeler_diagnostics.hpp"
#include "modeler/ros/node/turn_check.hpp"

namespace ribbon_mapper {
namespace {

constexpr const char* kStopped = "time went back, ~reset is awaited";

struct ModelerParameters {
  IntakeParameters lines;
  ModelerConfig config;
  double tf_cache_s;
  OnTimeJump on_time_jump;
  std::filesystem::path output_dir;

  static ModelerParameters read() {
    StrictParameters from;
    ModelerParameters p;
    p.lines = intake_parameters(from);
    p.tf_cache_s = from.number("tf_cache", 120.0, 10.0, 3600.0);
    p.on_time_jump = on_time_jump_from(from.text("on_time_jump", "reset"));
    p.output_dir = std::filesystem::absolute(
        from.filled_text("output_dir", "models", "a folder for saved models"));
    from.refuse_unknown();
    p.config = load_config(p.lines.config_file);
    return p;
  }
};

/// Runs the modeler on ROS. One thread serves all callbacks; none of them blocks.
class ModelerNode {
 public:
  explicit ModelerNode(const ModelerParameters& parameters);

 private:
  void on_scan(const sensor_msgs::LaserScan& scan);
  void on_corrected_trajectory(const nav_msgs::Path& path);
  bool on_reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool on_save(Save::Request& request, Save::Response& response);
  bool on_get_model(GetModel::Request& request, GetModel::Response& response);
  void check_clock();
  void on_time_jump();
  void empty_model();
  void take_lines();
  void report();
  void warn_of_doubts();

  ModelerParameters parameters_;
  ros::NodeHandle node_, private_node_{"~"};
  ModelKeeper keeper_;
  LineIntake intake_;
  ClockGuard clock_;
  AttentiveClock wait_clock_;
  TransformBuffer tf_;
  TfFeed tf_feed_;
  ModelPublisher publisher_;
  LineReport line_report_;
  ModelerDiagnostics diagnostics_;
  ros::ServiceServer reset_, save_, get_model_;
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
      intake_(parameters.lines.options, keeper_.log()),
      tf_(parameters.tf_cache_s, parameters.lines.tf_drop_frames),
      tf_feed_(node_, tf_, [this] { check_clock(); }),
      publisher_(private_node_, parameters.lines.options.frames.map),
      line_report_(keeper_.log(), intake_, tf_, node_.resolveName("scan")),
      diagnostics_(keeper_, line_report_) {
  reset_ = private_node_.advertiseService("reset", &ModelerNode::on_reset, this);
  save_ = private_node_.advertiseService("save", &ModelerNode::on_save, this);
  get_model_ = private_node_.advertiseService("get_model", &ModelerNode::on_get_model, this);
  corrected_trajectory_ =
      node_.subscribe("corrected_trajectory", 2, &ModelerNode::on_corrected_trajectory, this);
  // Subscribed last, so that everything is ready for the first line. The queue is long, so that no
  // line is lost during a correction.
  scan_ = node_.subscribe("scan", 5000, &ModelerNode::on_scan, this);
  line_timer_ = node_.createWallTimer(ros::WallDuration(0.02),
                                      [this](const ros::WallTimerEvent&) { take_lines(); });
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

void ModelerNode::on_corrected_trajectory(const nav_msgs::Path& path) {
  take_lines();
  try {
    const std::vector<StampedPose> trajectory =
        trajectory_of(path, parameters_.lines.options.frames.map);
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
  response = save_response(request.name, keeper_, parameters_.output_dir,
                           parameters_.lines.options.frames.map, changed_keys(parameters_.config));
  if (!response.success) ROS_ERROR("Not saved: %s", response.message.c_str());
  return true;
}

bool ModelerNode::on_get_model(GetModel::Request& request, GetModel::Response& response) {
  take_lines();
  response = model_response(request, keeper_, parameters_.lines.options.frames.map);
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

void ModelerNode::empty_model() {
  keeper_.reset();
  turns_.clear();
  line_report_.restart();
  barren_lines_ = {};
  reported_lines_ = 0;
}

void ModelerNode::report() {
  publisher_.publish(keeper_, intake_.done());
  diagnostics_.publish();
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
  ros::init(argc, argv, "modeler");
  const ros::NodeHandle keeps_logging_up;
  try {
    ribbon_mapper::ModelerNode node(ribbon_mapper::ModelerParameters::read());
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
