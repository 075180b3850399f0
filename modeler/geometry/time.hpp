// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cmath>

namespace ribbon_mapper {

/// Time since the epoch of the clock in use (wall or simulated), in nanoseconds as in ROS.
using Time = std::chrono::nanoseconds;

/// Returns a time in seconds.
inline double to_seconds(Time time) { return std::chrono::duration<double>(time).count(); }

/// Returns a time from seconds, rounded to the nanosecond.
inline Time from_seconds(double seconds) {
  return Time(static_cast<Time::rep>(std::llround(seconds * 1e9)));
}

}  // namespace ribbon_mapper
