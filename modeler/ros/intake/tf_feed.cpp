// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/tf_feed.hpp"

#include <ros/console.h>

#include <utility>

#include "modeler/ros/messages/message_conversions.hpp"

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
  buffer_.add(message, is_static);
  warn();
}

/// Says each thing once: a publisher that is wrong is wrong a hundred times a second.
void TfFeed::warn() {
  const TransformCounts& counts = buffer_.counts();
  if (counts.refused > 0 && !std::exchange(has_warned_.refused, true)) {
    ROS_WARN("A transform cannot be used: %s. Further ones are counted on /diagnostics.",
             counts.defect.c_str());
  }
  if (counts.repeated > 0 && !std::exchange(has_warned_.repeated, true)) {
    ROS_WARN(
        "Transforms are repeated with the same stamp; the first one counts. Do two nodes "
        "publish one frame, or does a bag play twice? They are counted on /diagnostics.");
  }
  if (counts.differing > 0 && !std::exchange(has_warned_.differing, true)) {
    ROS_WARN(
        "Repeated transforms say something else than the first: two nodes publish one frame, "
        "and do not agree. Stop one of them, or see ~tf_drop_frames.");
  }
  if (has_warned_.contradicted == buffer_.contradicted().size()) return;
  has_warned_.contradicted = buffer_.contradicted().size();
  ROS_WARN("Frame %s is on /tf_static and on /tf: the moving one counts.",
           shown(*buffer_.contradicted().rbegin()).c_str());
}

}  // namespace ribbon_mapper
