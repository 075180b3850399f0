// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include "modeler/ros/clock_guard.hpp"

namespace ribbon_mapper {

/// Fills a tf2 buffer from /tf and /tf_static. tf2_ros::TransformListener does so in a thread of its
/// own with a queue of 100 messages; this one is served with all other callbacks, in order of
/// arrival, and its queue outlasts a correction that takes seconds, even at several times real time.
class TfFeed {
 public:
  TfFeed(ros::NodeHandle& node, double cache_s);

  const tf2::BufferCore& buffer() const { return buffer_; }

 private:
  void take(const tf2_msgs::TFMessage& message, bool is_static);

  tf2::BufferCore buffer_;
  ClockGuard clock_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace ribbon_mapper
