// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/tf_feed.hpp"

#include <ros/console.h>
#include <tf2/exceptions.h>

namespace ribbon_mapper {

TfFeed::TfFeed(ros::NodeHandle& node, double cache_s) : buffer_(ros::Duration(cache_s)) {
  const auto no_delay = ros::TransportHints().tcpNoDelay();
  const boost::function<void(const tf2_msgs::TFMessage&)> take_moving =
      [this](const tf2_msgs::TFMessage& message) { take(message, false); };
  const boost::function<void(const tf2_msgs::TFMessage&)> take_fixed =
      [this](const tf2_msgs::TFMessage& message) { take(message, true); };
  fixed_ = node.subscribe<const tf2_msgs::TFMessage&>("/tf_static", 100, take_fixed, {}, no_delay);
  moving_ = node.subscribe<const tf2_msgs::TFMessage&>("/tf", 20000, take_moving, {}, no_delay);
}

void TfFeed::take(const tf2_msgs::TFMessage& message, bool is_static) {
  // tf2 refuses what is older than its newest data less the cache, so a new start needs it empty.
  if (clock_.went_back()) buffer_.clear();
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    try {
      buffer_.setTransform(transform, "tf", is_static);
    } catch (const tf2::TransformException& error) {
      ROS_WARN_THROTTLE(10.0, "A transform on /tf is left out: %s", error.what());
    }
  }
}

}  // namespace ribbon_mapper
