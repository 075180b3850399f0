// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <optional>
#include <string>
#include <vector>

#include "sim/ros/simulator_parameters.hpp"
#include "sim/ros/tilt_echo.hpp"
#include "sim/tour/tour.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::sim {

/// Publishes what the sensors, the localisation and the ground truth of a tour say. Time goes on in
/// ticks; the same tour gives the same messages, whatever the speed. Before the tour and after it
/// the robot stands.
class TourPublisher {
 public:
  /// Simulated time at the first tick and at the start of the tour; a stamp of zero means "unknown"
  /// in ROS, and tf must be there before the first line is.
  static constexpr Time kFirstTick = std::chrono::seconds(1);
  static constexpr Time kStart = std::chrono::seconds(2);
  static constexpr Time kTick = std::chrono::milliseconds(10);  ///< odometry's 100 Hz

  TourPublisher(ros::NodeHandle& node, const World& world, Tour& tour,
                const SimulatorFrames& frames);

  /// All that happens up to `now`, simulated time. Call it tick by tick.
  void tick(Time now);

  /// The tour has ended and its last line is out.
  bool finished(Time now) const { return now >= kStart + tour_.duration() && !next_scan_; }

  /// What the beams saw of the world, and that the tour has ended.
  void publish_truth();
  void publish_finished(bool finished);

  std::size_t lines() const { return lines_; }
  std::size_t lost_joints() const { return lost_joints_; }  ///< joint states that tf never got
  bool has_subscriber(const std::string& topic) const;

 private:
  Time in_tour(Time now) const;
  std_msgs::Header map_header(Time now) const;
  void publish_joints(Time now);
  void publish_base(Time now);
  void publish_localisation(Time now);
  void publish_scans(Time now);
  void publish_way(Time now);

  Tour& tour_;
  SimulatorFrames frames_;
  TruthCollector truth_;
  TiltEcho echo_;
  std::optional<Scan> next_scan_;
  std::size_t lines_ = 0, map_ticks_ = 0, lost_joints_ = 0;
  Time now_{0};
  ros::Publisher clock_, tf_, joints_, odometry_, true_pose_, scan_;
  ros::Publisher truth_planes_, true_way_, world_, finished_;
  std::vector<StampedPose> way_;
};

}  // namespace ribbon_mapper::sim
