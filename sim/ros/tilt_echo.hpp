// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>

#include <condition_variable>
#include <mutex>

namespace ribbon_mapper::sim {

/// Waits until robot_state_publisher has turned joint states into transforms.
///
/// Its queue holds a single message: at several times real time it loses every tenth, and tf then
/// has the tilt wrong by up to 8 degrees at a reversal. So the next joint state is sent only after
/// the transform of the one before has come back.
class TiltEcho {
 public:
  /// Subscribes to /tf. Another thread must serve the callbacks.
  explicit TiltEcho(ros::NodeHandle& node);

  /// Waits until tf has the tilt at `stamp`. Returns at once as long as nobody publishes the tilt.
  /// Returns false if the tilt does not come within 5 s of real time; until the next one comes,
  /// nobody counts as publishing it.
  bool wait_for(const ros::Time& stamp);

 private:
  void take(const tf2_msgs::TFMessage& message);

  std::mutex mutex_;
  std::condition_variable changed_;
  ros::Time newest_;  ///< of laser_tilt_mount_link in tf; zero: nobody publishes it
  ros::Subscriber tf_;
};

}  // namespace ribbon_mapper::sim
