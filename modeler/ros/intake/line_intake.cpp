// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/line_intake.hpp"

#include <utility>

#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/time_increment.hpp"

namespace ribbon_mapper {
namespace {
constexpr std::size_t kMaxWaiting = 5000;  // 25 s at five times real time; 10 MB
}  // namespace

void LineIntake::add(const sensor_msgs::LaserScan& scan, const Moment& now) {
  WaitingLine line{find_defect(scan), beams_of(scan), without_slash(scan.header.frame_id), now};
  line.beams.stamp += from_seconds(options_.scan_time_offset_s);
  if (!line.defect && line.beams.stamp <= Time(0)) line.defect = "stamp is zero";
  admit_held(now);
  const Run run = line.defect ? Run::current : sorter_.sort(scan.header.stamp);
  if (run == Run::current) {
    if (line.defect) {
      gaps_.saw_unusable();
    } else {
      log_.missing(gaps_.saw(scan.header.seq, scan.header.stamp));
      const auto doubt = timing_doubt(line.beams, scan.scan_time, gaps_.period_s());
      if (doubt && doubt->is_fault) log_.doubted(doubt->text);
    }
    admit(std::move(line));
  } else if (run == Run::next) {
    held_.push_back(std::move(line));
  }
}

void LineIntake::admit(WaitingLine line) {
  log_.received();
  waiting_.push_back(std::move(line));
  if (waiting_.size() > kMaxWaiting) drop_front("too many lines are waiting", waits_for_);
}

/// Admits lines held back once their run has begun, or when the clock shows no jump after all.
void LineIntake::admit_held(const Moment& now) {
  while (!held_.empty()) {
    const double waited_s = now.wall.toSec() - held_.front().arrived.wall.toSec();
    if (!held_are_current_ && waited_s < kMaxWaitForClock_s) break;
    admit(std::move(held_.front()));
    held_.pop_front();
  }
  held_are_current_ = false;
}

std::optional<ReadyLine> LineIntake::take_next(const tf2::BufferCore& tf, const Moment& now) {
  admit_held(now);
  return take(tf, [&](const WaitingLine& line) { return expired(line, now); });
}

std::optional<ReadyLine> LineIntake::take_next_at_end(const tf2::BufferCore& tf) {
  return take(tf, [](const WaitingLine&) { return true; });
}

template <typename GivesUp>
std::optional<ReadyLine> LineIntake::take(const tf2::BufferCore& tf, const GivesUp& gives_up) {
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
    auto found = find_line_poses(tf, options_.frames, line.frame, line.beams);
    if (LinePoses* poses = std::get_if<LinePoses>(&found)) {
      ReadyLine ready{std::move(line.beams), *poses, std::move(line.frame)};
      newest_ = done_ = ready.beams.stamp;
      waiting_.pop_front();
      return ready;
    }
    const auto& missing = std::get<MissingTransform>(found);
    waits_for_ = missing.reason;
    if (!gives_up(line)) return std::nullopt;
    drop_front(missing.reason, missing.detail);
  }
  waits_for_.clear();
  return std::nullopt;
}

void LineIntake::restart(const std::string& reason) {
  if (held_are_current_) {
    for (WaitingLine& line : std::exchange(held_, {})) admit(std::move(line));
  }
  held_are_current_ = false;
  for (std::size_t i = 0; i < waiting_.size(); ++i) log_.dropped(reason);
  waiting_.clear();
  waits_for_.clear();
  newest_ = done_ = Time(0);
  gaps_.restart();
}

void LineIntake::start_next_run(const std::string& reason) {
  restart(reason);
  sorter_.restart();
  for (const WaitingLine& line : held_) sorter_.sort(stamp_of(line.beams.stamp));
  held_are_current_ = true;
}

/// Requires both clocks to have advanced. Simulated time stops in a pause, when no transform can
/// come; in a fast replay it runs ahead of the wall time that the processes need.
bool LineIntake::expired(const WaitingLine& line, const Moment& now) const {
  // A ros::Duration cannot be longer than 68 years, and throws.
  return now.wall.toSec() - line.arrived.wall.toSec() > options_.transform_timeout_s &&
         now.data.toSec() - line.arrived.data.toSec() > options_.transform_timeout_s;
}

void LineIntake::drop_front(const std::string& reason, const std::string& detail) {
  log_.dropped(reason, detail);
  done_ = waiting_.front().beams.stamp;
  waiting_.pop_front();
}

}  // namespace ribbon_mapper
