// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace ribbon_mapper {

/// Simulated time that goes back by more than this was set back; less is jitter.
constexpr double kMinTimeJump_s = 1.0;

/// Notices when simulated time is set back because a bag or a simulation was started again.
class ClockGuard {
 public:
  /// Returns true once per jump. Always returns false with wall time, where a small step back only
  /// adjusts the clock.
  bool went_back() {
    if (!ros::Time::isSimTime()) return false;
    const ros::Time now = ros::Time::now();
    const bool back = now.toSec() + kMinTimeJump_s < newest_.toSec();
    if (back || now > newest_) newest_ = now;
    return back;
  }

 private:
  ros::Time newest_;
};

}  // namespace ribbon_mapper
