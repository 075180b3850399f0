// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include "modeler/ros/intake/clock_guard.hpp"

namespace ribbon_mapper {

/// A run of simulated time, which ends when time is set back.
enum class Run {
  previous,  ///< before the last jump: to be dropped
  current,   ///< since the last jump
  next,      ///< after a jump that /clock has not announced yet: to be held back
};

/// How long a message of the next run waits for /clock to announce the jump, on the wall clock.
constexpr double kMaxWaitForClock_s = 30.0;

/// Decides from stamps which run the messages of one source belong to. Topics have no common order,
/// so around a time jump messages may arrive before or after the matching /clock.
class RunSorter {
 public:
  /// Returns the run of a message and remembers its stamp if that run is the current one. Always
  /// returns Run::current with wall time.
  Run sort(const ros::Time& stamp) {
    if (!ros::Time::isSimTime()) return Run::current;
    if (newest_.isZero()) {
      if (has_restarted_ && stamp.toSec() > ros::Time::now().toSec() + kMinTimeJump_s) {
        return Run::previous;
      }
    } else if (stamp.toSec() + kMinTimeJump_s < newest_.toSec() ||
               (next_has_begun_ && stamp <= newest_)) {
      next_has_begun_ = true;
      return Run::next;
    }
    if (stamp > newest_) newest_ = stamp;
    return Run::current;
  }

  /// Starts the next run: /clock has gone back.
  void restart() {
    newest_ = ros::Time();
    has_restarted_ = true;
    next_has_begun_ = false;
  }

 private:
  ros::Time newest_;  ///< of the current run; zero before its first message
  bool has_restarted_ = false, next_has_begun_ = false;
};

}  // namespace ribbon_mapper
