// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <optional>
#include <string>

#include "modeler/ros/line_log.hpp"
#include "modeler/ros/line_poses.hpp"

namespace ribbon_mapper {

/// A line with all that the modeler needs to know of it.
struct ReadyLine {
  LaserBeams beams;
  LinePoses poses;
};

/// Keeps scans until tf knows where they were taken. Never waits: ask again later. A line whose
/// transforms do not come within the timeout is dropped, counted in the log by reason, and reported
/// with the missing frame's name.
class LineIntake {
 public:
  LineIntake(const Frames& frames, double transform_timeout_s, LineLog& log)
      : frames_(frames), timeout_s_(transform_timeout_s), log_(log) {}

  void add(const sensor_msgs::LaserScan& scan);

  /// The oldest line, once its poses are known.
  std::optional<ReadyLine> next(const tf2::BufferCore& tf);

  /// Forgets waiting lines and what time it was.
  void restart(const std::string& reason);

  std::size_t waiting() const { return waiting_.size(); }
  const std::string& waits_for() const { return waits_for_; }  ///< empty: for nothing
  Time done() const { return done_; }  ///< stamp of the last line handed out or dropped

 private:
  struct WaitingLine {
    std::optional<std::string> defect;
    LaserBeams beams;
    std::string frame;
    ros::Time arrived;
    ros::WallTime arrived_wall;
  };
  bool expired(const WaitingLine& line) const;
  void drop_front(const std::string& reason, const std::string& detail);

  Frames frames_;
  double timeout_s_;
  LineLog& log_;
  std::deque<WaitingLine> waiting_;
  std::string waits_for_;
  Time newest_{0};  ///< of the lines handed out
  Time done_{0};
};

}  // namespace ribbon_mapper
