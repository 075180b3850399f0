// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sim/ros/simulator_parameters.hpp"
#include "sim/ros/tilt_echo.hpp"
#include "sim/tour/tour.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::sim {

/// Publishes the clock, the sensors, the localisation and the ground truth of a tour.
///
/// Without localisation, there is no map -> odom. The odometry then starts at the robot's true
/// pose, so that a SLAM whose map is odom at the start has the frame of the ground truth.
///
/// With localisation, map -> odom jumps to where a corrected trajectory puts the robot, as any
/// SLAM's does (REP 105), if the trajectory comes after the tour. During the tour the localisation
/// drifts on: how messages race would decide which lines are placed after the jump.
///
/// Time advances in ticks; the same tour gives the same messages at any speed. The robot stands
/// still before and after the tour. The base laser's rays are cast while base_scan has a
/// subscriber. What they hit does not count as seen in the ground truth.
class TourPublisher {
 public:
  /// Simulated time at the first tick; a stamp of zero means "unknown" in ROS.
  static constexpr Time kFirstTick = std::chrono::seconds(1);
  /// Simulated time at the start of the tour; tf must be there before the first line.
  static constexpr Time kStart = std::chrono::seconds(2);
  /// Period of the ticks: that of odometry, 100 Hz.
  static constexpr Time kTick = std::chrono::milliseconds(10);

  /// Advertises the topics. `tour` must outlive this object.
  TourPublisher(ros::NodeHandle& node, const World& world, Tour& tour,
                const SimulatorFrames& frames, bool has_localisation);

  /// Publishes everything up to simulated time `now`. To be called tick by tick.
  void tick(Time now);

  /// Returns whether the tour has ended and its last line is published.
  bool finished(Time now) const { return now >= kStart + tour_.duration() && !next_scan_; }

  /// Publishes the true trajectory and the planes that the beams saw.
  void publish_truth();
  /// Publishes whether the tour has ended.
  void publish_finished(bool finished);

  /// Returns the number of lines of the tilting laser that are published.
  std::size_t lines() const { return lines_; }
  /// Returns the number of joint states that did not come back as transforms.
  std::size_t lost_joints() const { return lost_joints_; }
  /// Returns whether a topic of this object has a subscriber; with "TOPIC:N", whether it has N.
  /// Returns true for topics of others.
  bool has_subscribers(const std::string& topic) const;

 private:
  Time in_tour(Time now) const;
  Pose T_odom_base(Time at) const;
  Pose T_map_odom(Time now) const;
  void on_corrected_trajectory(const nav_msgs::Path& path);
  std_msgs::Header map_header(Time now) const;
  void publish_joints(Time now);
  void publish_base(Time now);
  void publish_localisation(Time now);
  void publish_scans(Time now);
  void publish_base_scans(Time now);
  void publish_true_path(Time now);

  Tour& tour_;
  SimulatorFrames frames_;
  bool has_localisation_;
  TruthCollector truth_;
  TiltEcho echo_;
  std::optional<Scan> next_scan_;
  std::size_t lines_ = 0, base_lines_ = 0, map_ticks_ = 0, lost_joints_ = 0;
  Time now_{0};
  ros::Publisher clock_, tf_, joints_, odometry_, true_pose_, scan_, base_scan_;
  ros::Publisher truth_planes_, true_path_, world_, finished_;
  std::vector<StampedPose> path_;
  mutable std::mutex correction_mutex_;   // the subscriber has a thread of its own
  bool is_over_ = false;                  // as was published
  std::optional<StampedPose> corrected_;  // newest pose of a trajectory that came since then
  ros::Subscriber corrected_trajectory_;
};

}  // namespace ribbon_mapper::sim
