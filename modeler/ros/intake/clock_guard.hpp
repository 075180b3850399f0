// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace ribbon_mapper {

/// Notices that simulated time was set back: a bag or a simulation was started again.
class ClockGuard {
 public:
  /// True once per jump of more than a second. Never with wall time, where a small step back is
  /// the clock being set right and no reason to forget anything.
  bool went_back() {
    if (!ros::Time::isSimTime()) return false;
    const ros::Time now = ros::Time::now();
    const bool back = now + ros::Duration(1.0) < newest_;
    if (back || now > newest_) newest_ = now;
    return back;
  }

 private:
  ros::Time newest_;
};

}  // namespace ribbon_mapper
