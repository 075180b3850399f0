// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include <stdexcept>

#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/strict_parameters.hpp"
#include "modeler/ros/run/run_node.hpp"
#include "sim/ros/loop_detector.hpp"
#include "sim/ros/pose_history.hpp"

namespace ribbon_mapper {
namespace {

struct NodeParameters {
  std::string map_frame, close_service;
  bool at_tour_end, at_loop;
  double radius_m, min_travel_m;

  static NodeParameters read() {
    StrictParameters from;
    NodeParameters p;
    p.map_frame = from.text("map_frame", "map");
    p.close_service = from.text("close_service", "");
    p.at_tour_end = from.flag("at_tour_end", true);
    p.at_loop = from.flag("at_loop", false);
    p.radius_m = from.number("radius", 0.5, 0.01, 100.0);
    p.min_travel_m = from.number("min_travel", 10.0, 0.1, 1e6);
    from.refuse_unknown();
    return p;
  }
};

/// Closes loops, once the modeler has handled every line taken until then. Simulates it: publishes
/// the true poses at the acquisition stamps of the modeler. With ~close_service, a SLAM closes.
class CorrectionNode {
 public:
  explicit CorrectionNode(const NodeParameters& parameters)
      : parameters_(parameters), loop_(parameters.radius_m, parameters.min_travel_m) {
    if (parameters_.close_service.empty()) {
      corrected_ = node_.advertise<nav_msgs::Path>("corrected_trajectory", 1, true);
    }
    tour_corrected_ = node_.advertise<std_msgs::Bool>("tour_corrected", 1, true);
    publish_tour_corrected(false);
    close_loop_ =
        private_node_.advertiseService("close_loop", &CorrectionNode::on_close_loop, this);
    truth_ = node_.subscribe("base_pose_ground_truth", 10000, &CorrectionNode::on_truth, this);
    scan_ = node_.subscribe("scan", 1000, &CorrectionNode::on_scan, this);
    finished_ = node_.subscribe("tour_finished", 2, &CorrectionNode::on_finished, this);
    trajectory_ = node_.subscribe("trajectory", 1, &CorrectionNode::on_trajectory, this);
  }

 private:
  void on_truth(const nav_msgs::Odometry& message) {
    const std::optional<Pose> pose = pose_of(message.pose.pose);
    if (!pose) return;
    const StampedPose stamped{time_of(message.header.stamp), *pose};
    if (!history_.empty() && stamped.stamp < history_.newest().stamp) start_next_run();
    history_.add(stamped);
    if (loop_.closes_with(*pose) && parameters_.at_loop) request("the robot is back at its start");
  }

  /// Forgets the run before: the simulation was started again.
  void start_next_run() {
    loop_ = LoopDetector(parameters_.radius_m, parameters_.min_travel_m);
    latest_ = {};
    is_requested_ = tour_is_over_ = false;
    last_scan_ = Time(0);
    publish_tour_corrected(false);
  }

  void on_scan(const sensor_msgs::LaserScan& scan) { last_scan_ = time_of(scan.header.stamp); }

  void on_finished(const std_msgs::Bool& finished) {
    tour_is_over_ = finished.data;
    if (tour_is_over_ && parameters_.at_tour_end) request("the tour has ended");
  }

  void on_trajectory(const nav_msgs::Path& path) {
    latest_ = path;
    if (!is_requested_ || time_of(path.header.stamp) < required_stamp_) return;
    is_requested_ = false;
    std::string message;
    if (correct(message)) return;
    ROS_ERROR("No correction: %s", message.c_str());
  }

  void request(const char* why) {
    ROS_INFO("Correction: %s. Waiting until the modeler has handled all lines.", why);
    is_requested_ = true;
    required_stamp_ = last_scan_;
    const nav_msgs::Path latest = latest_;
    on_trajectory(latest);  // which may have handled them already
  }

  bool on_close_loop(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    response.success = correct(response.message);
    return true;
  }

  void publish_tour_corrected(bool is_corrected) {
    std_msgs::Bool message;
    message.data = is_corrected;
    tour_corrected_.publish(message);
  }

  bool correct(std::string& message) {
    const bool is_corrected =
        parameters_.close_service.empty() ? correct_by_truth(message) : correct_by_slam(message);
    if (is_corrected && tour_is_over_) publish_tour_corrected(true);
    return is_corrected;
  }

  bool correct_by_slam(std::string& message) {
    std_srvs::Trigger close;
    if (!ros::service::call(parameters_.close_service, close)) {
      message = "no answer from " + parameters_.close_service + ": does the SLAM run?";
      return false;
    }
    message = close.response.message;
    return close.response.success;
  }

  bool correct_by_truth(std::string& message) {
    if (latest_.poses.empty()) {
      message = "no poses on " + trajectory_.getTopic() + " yet: does the modeler run?";
      return false;
    }
    try {
      const std::vector<StampedPose> poses =
          history_.at_stamps_of(trajectory_of(latest_, parameters_.map_frame));
      if (poses.empty()) throw std::invalid_argument("no ground truth at the modeler's stamps");
      corrected_.publish(path_message(poses, parameters_.map_frame, poses.back().stamp));
      message = "corrected trajectory of " + std::to_string(poses.size()) + " poses published";
      ROS_INFO("%s", message.c_str());
      return true;
    } catch (const std::invalid_argument& error) {
      message = error.what();
      return false;
    }
  }

  NodeParameters parameters_;
  ros::NodeHandle node_, private_node_{"~"};
  PoseHistory history_;
  LoopDetector loop_;
  nav_msgs::Path latest_;  ///< the modeler's trajectory
  Time last_scan_{0};
  bool is_requested_ = false, tour_is_over_ = false;
  Time required_stamp_{0};  ///< the modeler must have handled the lines up to here
  ros::Publisher corrected_, tour_corrected_;
  ros::ServiceServer close_loop_;
  ros::Subscriber truth_, scan_, finished_, trajectory_;
};

}  // namespace
}  // namespace ribbon_mapper

int main(int argc, char** argv) {
  const ribbon_mapper::NodeInfo info{
      "correction", "closes loops of a simulated tour by its true poses", "loop_closure.launch"};
  return ribbon_mapper::run_node(argc, argv, info, [] {
    ribbon_mapper::CorrectionNode node(ribbon_mapper::NodeParameters::read());
    ros::spin();
    return 0;
  });
}
