// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>

#include "modeler/ros/intake/transform_buffer.hpp"

namespace ribbon_mapper {

/// Fills a TransformBuffer from /tf and /tf_static.
///
/// tf2_ros::TransformListener does so in a thread of its own with a queue of 100 messages. This
/// class is served with all other callbacks of the node, in order of arrival. Its queue is long
/// enough for a correction of several seconds, even at several times real time.
class TfFeed {
 public:
  /// Subscribes. `buffer` must outlive this object; `check_clock` is called before each message, so
  /// that a time jump is noticed before its transforms.
  TfFeed(ros::NodeHandle& node, TransformBuffer& buffer, std::function<void()> check_clock);

 private:
  void take(const tf2_msgs::TFMessage& message, bool is_static);
  void warn();

  struct Warned {
    bool refused = false, repeated = false, differing = false;
    std::size_t contradicted = 0;  ///< frames
  };
  Warned has_warned_;
  TransformBuffer& buffer_;
  std::function<void()> check_clock_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace ribbon_mapper
