// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/tilt_echo.hpp"

#include <chrono>

namespace ribbon_mapper::sim {
namespace {
constexpr std::chrono::seconds kMaxWait{5};  // a loaded machine may need that long
}  // namespace

TiltEcho::TiltEcho(ros::NodeHandle& node)
    : tf_(node.subscribe("/tf", 1000, &TiltEcho::take, this, ros::TransportHints().tcpNoDelay())) {}

bool TiltEcho::wait_for(const ros::Time& stamp) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (newest_.isZero()) return true;
  if (changed_.wait_for(lock, kMaxWait, [&] { return newest_ >= stamp; })) return true;
  newest_ = ros::Time();
  return false;
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
