// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>

#include <condition_variable>
#include <mutex>

namespace ribbon_mapper::sim {

/// Hears what robot_state_publisher makes of joint_states. Its queue holds a single message: at
/// several times real time it loses every tenth, and then tf has the tilt wrong by up to 8 degrees
/// at a reversal. So the next joint state waits until this one has come back.
class TiltEcho {
 public:
  explicit TiltEcho(ros::NodeHandle& node);

  /// Returns when tf has the tilt at `stamp`, at once if nobody has ever answered. False, after a
  /// tenth of a second of real time, if it does not come.
  bool wait_for(const ros::Time& stamp);

 private:
  void take(const tf2_msgs::TFMessage& message);

  std::mutex mutex_;
  std::condition_variable changed_;
  ros::Time newest_;  ///< of laser_tilt_mount_link in tf; zero: none yet
  ros::Subscriber tf_;
};

}  // namespace ribbon_mapper::sim
