// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <optional>
#include <string>

#include "modeler/ros/intake/line_log.hpp"
#include "modeler/ros/intake/line_poses.hpp"

namespace ribbon_mapper {

/// A line with all that the modeler needs to know of it.
struct ReadyLine {
  LaserBeams beams;
  LinePoses poses;
};

/// When something happened, by the clock of the data and by that on the wall. In a bag that is read
/// as fast as it goes, both are the time of the recording.
struct Moment {
  ros::Time data;
  ros::WallTime wall;

  static Moment now() { return {ros::Time::now(), ros::WallTime::now()}; }
  static Moment recorded(const ros::Time& time) {
    return {time, ros::WallTime(time.sec, time.nsec)};
  }
};

struct IntakeOptions {
  Frames frames;
  double transform_timeout_s = 2.0;
  /// Added to every scan's stamp: laser drivers are off by a constant of up to 25 ms.
  double scan_time_offset_s = 0.0;
};

/// Keeps scans until tf knows where they were taken. Never waits: ask again later. A line whose
/// transforms do not come within the timeout is dropped, and counted in the log by reason, with the
/// missing frame's name.
class LineIntake {
 public:
  LineIntake(const IntakeOptions& options, LineLog& log) : options_(options), log_(log) {}

  void add(const sensor_msgs::LaserScan& scan, const Moment& now);

  /// The oldest line, once its poses are known.
  std::optional<ReadyLine> next(const tf2::BufferCore& tf, const Moment& now);

  /// As next(), when nothing more can come: lines that lack a transform are dropped.
  std::optional<ReadyLine> last(const tf2::BufferCore& tf);

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
    Moment arrived;
  };
  template <typename GivesUp>
  std::optional<ReadyLine> take(const tf2::BufferCore& tf, const GivesUp& gives_up);
  bool expired(const WaitingLine& line, const Moment& now) const;
  void drop_front(const std::string& reason, const std::string& detail);

  IntakeOptions options_;
  LineLog& log_;
  std::deque<WaitingLine> waiting_;
  std::string waits_for_;
  Time newest_{0};  ///< of the lines handed out
  Time done_{0};
};

}  // namespace ribbon_mapper
