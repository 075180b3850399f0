// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/slam_publisher.hpp"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Path.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>

#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper::slam {
namespace {

geometry_msgs::PoseWithCovarianceStamped pose_with_covariance(const PoseOfNow& now,
                                                              const std::string& frame) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.frame_id = frame;
  message.header.stamp = stamp_of(now.stamp);
  message.pose.pose = pose_message(now.T_map_base);
  for (int i = 0; i < 36; ++i)
    message.pose.covariance[static_cast<std::size_t>(i)] = now.covariance(i / 6, i % 6);
  return message;
}

}  // namespace

SlamPublisher::SlamPublisher(ros::NodeHandle& node, ros::NodeHandle& private_node,
                             const SlamParameters& parameters)
    : map_frame_(parameters.map_frame),
      odom_frame_(parameters.lines.options.frames.odom),
      publishes_tf_(parameters.publish_tf),
      tolerance_(parameters.transform_tolerance_s) {
  trajectory_ = node.advertise<nav_msgs::Path>("corrected_trajectory", 2, true);
  pose_ = private_node.advertise<geometry_msgs::PoseWithCovarianceStamped>("pose", 100);
  if (publishes_tf_) tf_ = node.advertise<tf2_msgs::TFMessage>("/tf", 1000);
}

void SlamPublisher::publish(const EstimateNews& news) {
  if (news.now) {
    T_map_odom_ = news.now->T_map_odom();
    pose_.publish(pose_with_covariance(*news.now, map_frame_));
  }
  if (!news.revision) return;
  // tf first: lines after the trajectory are placed by it.
  publish_transform();
  trajectory_.publish(path_message(*news.revision, map_frame_, news.revision->back().stamp));
}

void SlamPublisher::publish_transform() {
  const ros::Time now = ros::Time::now();
  if (!publishes_tf_ || now.isZero() || now.toSec() + 1.0 > ros::TIME_MAX.toSec()) return;
  const ros::Time stamp = now + tolerance_;
  if (stamp <= newest_) return;
  tf2_msgs::TFMessage message;
  if (newest_.isZero()) {
    const double begin_s = std::max(now.toSec() - kMinTimeJump_s, 1e-3);  // zero is "any time"
    message.transforms.push_back(transform(ros::Time(begin_s)));
  }
  message.transforms.push_back(transform(stamp));
  newest_ = stamp;
  tf_.publish(message);
}

geometry_msgs::TransformStamped SlamPublisher::transform(const ros::Time& stamp) const {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = map_frame_;
  message.header.stamp = stamp;
  message.child_frame_id = odom_frame_;
  message.transform = transform_message(T_map_odom_);
  return message;
}

}  // namespace ribbon_mapper::slam
