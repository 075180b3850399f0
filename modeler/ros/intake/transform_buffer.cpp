// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/transform_buffer.hpp"

#include <utility>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {

TransformBuffer::TransformBuffer(double cache_s, std::set<std::string> drop_frames,
                                 Listener listener)
    : cache_s_(cache_s),
      buffer_(std::make_unique<tf2::BufferCore>(ros::Duration(cache_s))),
      drop_frames_(std::move(drop_frames)),
      listener_(std::move(listener)) {}

void TransformBuffer::add(const tf2_msgs::TFMessage& message, bool is_static) {
  received_ += message.transforms.size();
  if (is_static) return enter_static(message);
  enter_expired();
  tf2_msgs::TFMessage current;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (is_used(transform)) {
      delays_s_[without_slash(transform.child_frame_id)] =
          ros::Time::now().toSec() - transform.header.stamp.toSec();
    }
    const Run run = sorters_[transform.child_frame_id].sort(transform.header.stamp);
    if (run == Run::current) current.transforms.push_back(transform);
    if (run == Run::next) held_.push_back({transform, ros::WallTime::now()});
  }
  enter(current);
}

bool TransformBuffer::is_used(const geometry_msgs::TransformStamped& transform) const {
  return drop_frames_.count(without_slash(transform.header.frame_id)) == 0 &&
         !find_defect(transform);
}

double TransformBuffer::delay_s(const std::string& child) const {
  const auto found = delays_s_.find(child);
  return found == delays_s_.end() ? 0.0 : found->second;
}

void TransformBuffer::start_next_run() {
  buffer_->clear();  // static transforms are kept by tf2
  for (auto& [child, sorter] : sorters_) sorter.restart();
  tf2_msgs::TFMessage next_run;
  for (Held& held : std::exchange(held_, {})) {
    sorters_[held.transform.child_frame_id].sort(held.transform.header.stamp);
    next_run.transforms.push_back(std::move(held.transform));
  }
  enter(next_run);
}

void TransformBuffer::enter(const tf2_msgs::TFMessage& message) {
  take_out_static(message);
  counts_ += enter_transforms(message, false, drop_frames_, *buffer_);
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (listener_) listener_(transform);
  }
}

/// Enters what was held back although time was not set back: it is merely late.
void TransformBuffer::enter_expired() {
  tf2_msgs::TFMessage late;
  const ros::WallTime now = ros::WallTime::now();
  while (!held_.empty() && (now - held_.front().arrived).toSec() > kMaxWaitForClock_s) {
    late.transforms.push_back(std::move(held_.front().transform));
    held_.pop_front();
  }
  enter(late);
}

void TransformBuffer::enter_static(const tf2_msgs::TFMessage& message) {
  tf2_msgs::TFMessage fixed;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const std::string child = without_slash(transform.child_frame_id);
    if (delays_s_.count(child) != 0) {
      contradicted_.insert(child);
      continue;
    }
    if (is_used(transform)) fixed_[child] = transform;
    fixed.transforms.push_back(transform);
  }
  counts_ += enter_transforms(fixed, true, drop_frames_, *buffer_);
}

/// tf2 keeps one kind of transforms for each frame, that of the first: a new buffer is needed.
void TransformBuffer::take_out_static(const tf2_msgs::TFMessage& moving) {
  bool is_out = false;
  for (const geometry_msgs::TransformStamped& transform : moving.transforms) {
    const std::string child = without_slash(transform.child_frame_id);
    if (!is_used(transform) || fixed_.erase(child) == 0) continue;
    contradicted_.insert(child);
    is_out = true;
  }
  if (!is_out) return;
  buffer_ = std::make_unique<tf2::BufferCore>(ros::Duration(cache_s_));
  tf2_msgs::TFMessage fixed;
  for (const auto& [child, transform] : fixed_) fixed.transforms.push_back(transform);
  enter_transforms(fixed, true, drop_frames_, *buffer_);
}

}  // namespace ribbon_mapper
