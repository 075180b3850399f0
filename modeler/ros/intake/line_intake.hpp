// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "modeler/ros/intake/line_gaps.hpp"
#include "modeler/ros/intake/line_log.hpp"
#include "modeler/ros/intake/line_poses.hpp"
#include "modeler/ros/intake/run_sorter.hpp"

namespace ribbon_mapper {

/// A scan line with everything that the modeler needs to take it.
struct ReadyLine {
  LaserBeams beams;     ///< ranges, angles and times
  LinePoses poses;      ///< of robot and laser during the line
  std::string frame{};  ///< of the laser
};

/// A point in time on two clocks, that of the data and that on the wall. For a bag that is read
/// without a master, both are the time of the recording.
struct Moment {
  ros::Time data;      ///< simulated time or wall time, as the messages are stamped
  ros::WallTime wall;  ///< never simulated

  /// Returns the present moment.
  static Moment now() { return {ros::Time::now(), ros::WallTime::now()}; }
  /// Returns the moment at which a message was recorded.
  static Moment recorded(const ros::Time& time) {
    return {time, ros::WallTime(time.sec, time.nsec)};
  }
};

/// Tells the present moment with the wall time in which a node was there for its messages. A pause
/// between two calls counts as a tenth of a second at most: what has come meanwhile is in the
/// node's queues, and no line is to be given up before that is read.
class AttentiveClock {
 public:
  /// Returns the present moment. To be called often.
  Moment now() { return at(Moment::now()); }

  /// Returns the moment for what both clocks show.
  Moment at(const Moment& shown) {
    const ros::WallDuration longest(0.1);
    const ros::WallDuration step = shown.wall - last_;
    if (last_.isZero()) attended_ = shown.wall;
    if (!last_.isZero()) attended_ += std::min(std::max(step, ros::WallDuration(0.0)), longest);
    last_ = shown.wall;
    return {shown.data, attended_};
  }

 private:
  ros::WallTime last_, attended_;
};

/// Settings of a LineIntake.
struct IntakeOptions {
  Frames frames;                     ///< names of map, odom and base in tf
  double transform_timeout_s = 2.0;  ///< a line waits this long for its transforms
  /// Added to the stamp of every scan. Laser drivers are off by a constant of up to 25 ms.
  double scan_time_offset_s = 0.0;
};

/// Keeps scans until tf knows where they were taken. Never blocks: the caller asks again later.
/// Drops a line whose transforms do not come within the timeout, and counts it in the log by
/// reason, with the name of the missing frame.
class LineIntake {
 public:
  /// Creates an empty intake. `log` must outlive it.
  LineIntake(const IntakeOptions& options, LineLog& log) : options_(options), log_(log) {}

  /// Adds a scan that arrived at `now`. Scans of the next run (see RunSorter) are held back until
  /// start_next_run().
  void add(const sensor_msgs::LaserScan& scan, const Moment& now);

  /// Removes and returns the oldest line if its poses are known, else returns nothing.
  std::optional<ReadyLine> take_next(const tf2::BufferCore& tf, const Moment& now);

  /// Removes and returns the oldest line that has its poses, when no more data will come: lines
  /// before it are dropped. Returns nothing once the intake is empty.
  std::optional<ReadyLine> take_next_at_end(const tf2::BufferCore& tf);

  /// Drops the waiting lines for `reason` and accepts lines of any stamp again.
  void restart(const std::string& reason);

  /// Does the same when simulated time was set back, and goes on with the lines held back.
  void start_next_run(const std::string& reason);

  /// Returns the settings.
  const IntakeOptions& options() const { return options_; }
  /// Returns the number of lines that wait for transforms.
  std::size_t waiting() const { return waiting_.size(); }
  /// Returns what the oldest line is waiting for; empty if it is not waiting.
  const std::string& waits_for() const { return waits_for_; }
  /// Returns the stamp of the last line handed out or dropped.
  Time done() const { return done_; }

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
  void admit(WaitingLine line);
  void admit_held(const Moment& now);
  void drop_front(const std::string& reason, const std::string& detail);

  IntakeOptions options_;
  LineLog& log_;
  RunSorter sorter_;
  LineGaps gaps_;
  std::deque<WaitingLine> waiting_;
  std::deque<WaitingLine> held_;  ///< of the next run
  bool held_are_current_ = false;
  std::string waits_for_;
  Time newest_{0};  ///< of the lines handed out
  Time done_{0};
};

}  // namespace ribbon_mapper
