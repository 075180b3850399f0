// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/tf_feed.hpp"

#include <ros/console.h>

#include <utility>

#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {

TfFeed::TfFeed(ros::NodeHandle& node, double cache_s, std::set<std::string> drop_frames)
    : buffer_(ros::Duration(cache_s)), drop_frames_(std::move(drop_frames)) {
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
  transforms_ += message.transforms.size();
  const std::size_t refused = enter_transforms(message, is_static, drop_frames_, buffer_);
  if (refused > 0) ROS_WARN_THROTTLE(10.0, "%zu transforms on /tf are not usable.", refused);
}

}  // namespace ribbon_mapper
