// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/tilt_echo.hpp"

namespace ribbon_mapper::sim {

TiltEcho::TiltEcho(ros::NodeHandle& node)
    : tf_(node.subscribe("/tf", 1000, &TiltEcho::take, this, ros::TransportHints().tcpNoDelay())) {}

bool TiltEcho::wait_for(const ros::Time& stamp) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (newest_.isZero()) return true;
  return changed_.wait_for(lock, std::chrono::milliseconds(100), [&] { return newest_ >= stamp; });
}

void TiltEcho::take(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (transform.child_frame_id != "laser_tilt_mount_link") continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = transform.header.stamp;
    changed_.notify_all();
  }
}

}  // namespace ribbon_mapper::sim
