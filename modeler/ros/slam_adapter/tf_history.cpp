// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/slam_adapter/tf_history.hpp"

#include <tf2/exceptions.h>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kSame_m = 1e-4, kSame_rad = 1e-4;
constexpr std::size_t kMaxWaiting = 1000;

}  // namespace

void TfHistory::take(Time stamp, const Pose& T_map_odom) {
  if (last_T_map_odom_) {
    const Pose change = last_T_map_odom_->inverse(Eigen::Isometry) * T_map_odom;
    if (change.translation().norm() < kSame_m && angle_of(change) < kSame_rad) return;
  }
  last_T_map_odom_ = T_map_odom;
  waiting_.push_back({stamp, T_map_odom});
  if (waiting_.size() > kMaxWaiting) waiting_.pop_front();
}

void TfHistory::look_up(const tf2::BufferCore& tf) {
  while (!waiting_.empty()) {
    const Waiting& next = waiting_.front();
    try {
      const Pose T_odom_base =
          pose_of(tf.lookupTransform(frames_.odom, frames_.base, stamp_of(next.stamp)).transform);
      if (trajectory_.empty() || next.stamp > trajectory_.back().stamp) {
        trajectory_.push_back({next.stamp, next.T_map_odom * T_odom_base});
      }
    } catch (const tf2::ExtrapolationException&) {
      if (waiting_.size() < 100) return;   // not yet, or too old
    } catch (const std::runtime_error&) {  // of tf2; of ROS if times are 68 years apart
      return;
    }
    waiting_.pop_front();
  }
}

}  // namespace ribbon_mapper
