// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/line_intake.hpp"

#include <ros/console.h>

#include <algorithm>

#include "modeler/ros/message_conversions.hpp"

namespace ribbon_mapper {
namespace {
constexpr std::size_t kMostWaiting = 5000;  // 25 s at five times real time; 10 MB
}  // namespace

void LineIntake::add(const sensor_msgs::LaserScan& scan) {
  log_.received();
  waiting_.push_back({defect_of(scan), beams_of(scan), without_slash(scan.header.frame_id),
                      ros::Time::now(), ros::WallTime::now()});
  if (waiting_.size() > kMostWaiting) drop_front("too many lines are waiting", waits_for_);
}

std::optional<ReadyLine> LineIntake::next(const tf2::BufferCore& tf) {
  while (!waiting_.empty()) {
    WaitingLine& line = waiting_.front();
    if (line.defect) {
      drop_front("malformed", *line.defect + ": look at the laser's driver");
      continue;
    }
    if (line.beams.stamp <= newest_) {
      drop_front("out of order", "it is stamped before the line before it");
      continue;
    }
    auto found = find_line_poses(tf, frames_, line.frame, line.beams);
    if (LinePoses* poses = std::get_if<LinePoses>(&found)) {
      ReadyLine ready{std::move(line.beams), *poses};
      newest_ = done_ = ready.beams.stamp;
      waiting_.pop_front();
      return ready;
    }
    const auto& missing = std::get<MissingTransform>(found);
    waits_for_ = missing.reason;
    if (!expired(line)) return std::nullopt;
    drop_front(missing.reason, missing.detail);
  }
  waits_for_.clear();
  return std::nullopt;
}

void LineIntake::restart(const std::string& reason) {
  for (std::size_t i = 0; i < waiting_.size(); ++i) log_.dropped(reason);
  waiting_.clear();
  waits_for_.clear();
  newest_ = done_ = Time(0);
}

/// Both clocks must have moved on: simulated time stops in a pause, in which nothing can come, and
/// runs faster than wall time in a replay, when two processes need a moment all the same.
bool LineIntake::expired(const WaitingLine& line) const {
  return (ros::WallTime::now() - line.arrived_wall).toSec() > timeout_s_ &&
         (ros::Time::now() - line.arrived).toSec() > timeout_s_;
}

void LineIntake::drop_front(const std::string& reason, const std::string& detail) {
  log_.dropped(reason);
  ROS_WARN_THROTTLE(5.0, "A line is dropped: %s (%s). %zu dropped so far.", reason.c_str(),
                    detail.c_str(), log_.dropped_lines());
  done_ = waiting_.front().beams.stamp;
  waiting_.pop_front();
}

}  // namespace ribbon_mapper
