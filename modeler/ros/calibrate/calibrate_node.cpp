// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include <cstdio>
#include <filesystem>

#include "modeler/calibration/calibration.hpp"
#include "modeler/io/calibrated_preset.hpp"
#include "modeler/io/config_file.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/tf_feed.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/intake_parameters.hpp"
#include "modeler/ros/run/run_node.hpp"
#include "modeler/storage/atomic_file.hpp"
#include "modeler/storage/disk.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kTfCache_s = 120.0;

struct CalibrateParameters {
  IntakeParameters lines;
  ModelerConfig config;
  double travel_m;
  std::filesystem::path output;

  static CalibrateParameters read() {
    StrictParameters from;
    CalibrateParameters p;
    p.lines = intake_parameters(from);
    p.output = std::filesystem::absolute(from.required_text("output", "the preset to write"));
    p.travel_m = from.number("travel", 5.0, 1.0, 100.0);
    from.refuse_unknown();
    p.config = load_config(p.lines.config_file);
    return p;
  }
};

/// Learns the tolerances (section 5.1 of the paper) while the robot first stands before a bare wall
/// and then moves in front of it. Ends when it has driven ~travel, when the simulated tour has
/// ended, or when somebody calls ~finish.
class CalibrateNode {
 public:
  explicit CalibrateNode(const CalibrateParameters& parameters)
      : parameters_(parameters),
        intake_(parameters.lines.options, log_),
        tf_(kTfCache_s, parameters.lines.tf_drop_frames),
        tf_feed_(node_, tf_, [this] { check_clock(); }),
        calibrator_(parameters.config) {
    create_directory_for_files(parameters.output.parent_path());  // better now than after the drive
    finish_ = private_node_.advertiseService("finish", &CalibrateNode::on_finish, this);
    tour_finished_ = node_.subscribe("tour_finished", 2, &CalibrateNode::on_tour_finished, this);
    scan_ = node_.subscribe("scan", 5000, &CalibrateNode::on_scan, this);
    line_timer_ = node_.createWallTimer(ros::WallDuration(0.02),
                                        [this](const ros::WallTimerEvent&) { take_lines(); });
    report_timer_ = node_.createWallTimer(ros::WallDuration(5.0),
                                          [this](const ros::WallTimerEvent&) { report(); });
  }

  bool is_done() const { return is_done_; }

 private:
  /// Starts again when simulated time was set back: lines of two runs do not fit one trajectory.
  void check_clock() {
    if (!clock_.went_back()) return;
    tf_.start_next_run();
    intake_.start_next_run("the clock was set back");
    log_ = {};
    calibrator_ = Calibrator(parameters_.config);
    ROS_WARN("Simulated time went back: the calibration starts again");
  }

  void on_scan(const sensor_msgs::LaserScan& scan) {
    check_clock();
    intake_.add(scan, wait_clock_.now());
    take_lines();
  }

  void take_lines() {
    check_clock();
    const Moment now = wait_clock_.now();
    while (const std::optional<ReadyLine> line = intake_.take_next(tf_.core(), now)) {
      calibrator_.add(line->beams, line->poses);
    }
    const bool is_over = tour_is_over_ && intake_.waiting() == 0;
    if (!is_over && calibrator_.travel_m() < parameters_.travel_m) return;
    std::string message;
    finish(message);
    ros::shutdown();
  }

  bool finish(std::string& message) {
    try {
      const Calibration calibration = calibrator_.result();
      write_file_atomically(parameters_.output,
                            calibrated_preset(parameters_.config, calibration,
                                              "calibrate.launch, scans on " + scan_.getTopic()));
      std::printf("\n%s\npreset in %s\n", calibration_table(calibration).c_str(),
                  parameters_.output.c_str());
      std::fflush(stdout);
      message = "preset in " + parameters_.output.string();
      return is_done_ = true;
    } catch (const std::runtime_error& error) {
      message = error.what();
      ROS_ERROR("%s", error.what());
      return false;
    }
  }

  bool on_finish(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    response.success = finish(response.message);
    return true;
  }

  void on_tour_finished(const std_msgs::Bool& finished) { tour_is_over_ = finished.data; }

  void report() {
    if (log_.lines() == 0) {
      ROS_INFO("Waiting for scans on %s", scan_.getTopic().c_str());
    } else if (calibrator_.travel_m() == 0.0) {
      ROS_INFO("%zu lines from rest; %s", calibrator_.lines_stopped(),
               calibrator_.has_rested() ? "drive the robot 3 to 5 m before the wall now"
                                        : "let the robot stand before a bare wall");
    } else {
      ROS_INFO("%.1f m driven, %zu lines dropped %s", calibrator_.travel_m(), log_.dropped_lines(),
               log_.newest_drop().c_str());
    }
  }

  CalibrateParameters parameters_;
  ros::NodeHandle node_, private_node_{"~"};
  LineLog log_;
  LineIntake intake_;
  ClockGuard clock_;
  AttentiveClock wait_clock_;
  TransformBuffer tf_;
  TfFeed tf_feed_;
  Calibrator calibrator_;
  bool tour_is_over_ = false, is_done_ = false;
  ros::ServiceServer finish_;
  ros::Subscriber tour_finished_, scan_;
  ros::WallTimer line_timer_, report_timer_;
};

}  // namespace
}  // namespace ribbon_mapper

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{"calibrate", "learns tolerances in front of a bare wall",
                                     "calibrate.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    return ribbon_mapper::run_program("calibrate", [] {  // rosconsole may be down at its end
      ribbon_mapper::CalibrateNode node(ribbon_mapper::CalibrateParameters::read());
      ros::spin();
      return node.is_done() ? 0 : 1;
    });
  });
}
