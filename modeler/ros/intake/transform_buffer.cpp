// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/transform_buffer.hpp"

#include <utility>

#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {

TransformBuffer::TransformBuffer(double cache_s, std::set<std::string> drop_frames,
                                 Listener listener)
    : buffer_(ros::Duration(cache_s)),
      drop_frames_(std::move(drop_frames)),
      listener_(std::move(listener)) {}

std::size_t TransformBuffer::add(const tf2_msgs::TFMessage& message, bool is_static) {
  received_ += message.transforms.size();
  if (is_static) return enter_transforms(message, true, drop_frames_, buffer_);
  const std::size_t refused = enter_expired();
  tf2_msgs::TFMessage current;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const Run run = sorters_[transform.child_frame_id].sort(transform.header.stamp);
    if (run == Run::current) current.transforms.push_back(transform);
    if (run == Run::next) held_.push_back({transform, ros::WallTime::now()});
  }
  return refused + enter(current);
}

void TransformBuffer::start_next_run() {
  buffer_.clear();  // static transforms are kept by tf2
  for (auto& [child, sorter] : sorters_) sorter.restart();
  tf2_msgs::TFMessage next_run;
  for (Held& held : std::exchange(held_, {})) {
    sorters_[held.transform.child_frame_id].sort(held.transform.header.stamp);
    next_run.transforms.push_back(std::move(held.transform));
  }
  enter(next_run);
}

std::size_t TransformBuffer::enter(const tf2_msgs::TFMessage& message) {
  const std::size_t refused = enter_transforms(message, false, drop_frames_, buffer_);
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (listener_) listener_(transform);
  }
  return refused;
}

/// Enters what was held back although time was not set back: it is merely late.
std::size_t TransformBuffer::enter_expired() {
  tf2_msgs::TFMessage late;
  const ros::WallTime now = ros::WallTime::now();
  while (!held_.empty() && (now - held_.front().arrived).toSec() > kMaxWaitForClock_s) {
    late.transforms.push_back(std::move(held_.front().transform));
    held_.pop_front();
  }
  return enter(late);
}

}  // namespace ribbon_mapper
