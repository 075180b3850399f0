// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "slam/node/estimate_worker.hpp"
#include "slam/node/slam_parameters.hpp"

namespace ribbon_mapper::slam {

/// Publishes an estimate: corrected_trajectory, ~pose, and map -> odom in tf.
class SlamPublisher {
 public:
  /// Advertises the topics.
  SlamPublisher(ros::NodeHandle& node, ros::NodeHandle& private_node,
                const SlamParameters& parameters);

  /// Publishes the newest trajectory and the newest pose, if there are new ones.
  void publish(const EstimateNews& news);

  /// Publishes map -> odom as of now, unless the clock stands still. To be called often. The first
  /// time, it is also published for the second before, in which the first lines may begin.
  void publish_transform();

  /// Starts again where map is odom.
  void reset() { T_map_odom_ = Pose::Identity(); }

  /// Publishes transforms of any stamp again: the clock was set back.
  void forget_clock() { newest_ = ros::Time(); }

  /// Returns the topic of the trajectory.
  std::string trajectory_topic() const { return trajectory_.getTopic(); }

 private:
  geometry_msgs::TransformStamped transform(const ros::Time& stamp) const;

  std::string map_frame_, odom_frame_;
  bool publishes_tf_;
  ros::Duration tolerance_;
  ros::Publisher trajectory_, pose_, tf_;
  Pose T_map_odom_ = Pose::Identity();
  ros::Time newest_;  ///< stamp of the last transform
};

}  // namespace ribbon_mapper::slam
