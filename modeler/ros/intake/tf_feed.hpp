// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <string>

#include "modeler/ros/intake/clock_guard.hpp"

namespace ribbon_mapper {

/// Fills a tf2 buffer from /tf and /tf_static. tf2_ros::TransformListener does so in a thread of
/// its own with a queue of 100 messages; this one is served with all other callbacks, in order of
/// arrival, and its queue outlasts a correction that takes seconds, even at several times real
/// time.
class TfFeed {
 public:
  /// Transforms whose parent is one of `drop_frames` are left out, see enter_transforms().
  TfFeed(ros::NodeHandle& node, double cache_s, std::set<std::string> drop_frames);

  const tf2::BufferCore& buffer() const { return buffer_; }
  std::size_t transforms() const { return transforms_; }  ///< that came in

 private:
  void take(const tf2_msgs::TFMessage& message, bool is_static);

  tf2::BufferCore buffer_;
  std::set<std::string> drop_frames_;
  std::size_t transforms_ = 0;
  ClockGuard clock_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace ribbon_mapper
