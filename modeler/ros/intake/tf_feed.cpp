// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/tf_feed.hpp"

#include <ros/console.h>

#include <utility>

namespace ribbon_mapper {

TfFeed::TfFeed(ros::NodeHandle& node, TransformBuffer& buffer, std::function<void()> check_clock)
    : buffer_(buffer), check_clock_(std::move(check_clock)) {
  const auto no_delay = ros::TransportHints().tcpNoDelay();
  const boost::function<void(const tf2_msgs::TFMessage&)> take_moving =
      [this](const tf2_msgs::TFMessage& message) { take(message, false); };
  const boost::function<void(const tf2_msgs::TFMessage&)> take_fixed =
      [this](const tf2_msgs::TFMessage& message) { take(message, true); };
  fixed_ = node.subscribe<const tf2_msgs::TFMessage&>("/tf_static", 100, take_fixed, {}, no_delay);
  moving_ = node.subscribe<const tf2_msgs::TFMessage&>("/tf", 20000, take_moving, {}, no_delay);
}

void TfFeed::take(const tf2_msgs::TFMessage& message, bool is_static) {
  check_clock_();
  const std::size_t refused = buffer_.add(message, is_static);
  if (refused > 0) ROS_WARN_THROTTLE(10.0, "%zu transforms on /tf are not usable.", refused);
}

}  // namespace ribbon_mapper
