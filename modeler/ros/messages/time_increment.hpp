// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Returns the time increment of a laser that turns once in `period_s`, at a constant speed.
double time_increment_of(double period_s, double angle_increment_rad);

/// Returns true if a laser that takes a line in every period can have this time increment. The line
/// takes at least the part of a turn that it covers, and at most the whole period. A time increment
/// of 0 means that it is not known, which is possible.
bool fits_period(double time_increment_s, const LaserBeams& beams, double period_s);

/// Returns true if the period is that of several whole turns, of which the laser takes one: a
/// Hokuyo that skips scans. No laser turns in less than 10 ms.
bool leaves_turns_out(const LaserBeams& beams, double period_s);

/// A contradiction between the time fields of lines and the period in which they come.
struct TimingDoubt {
  std::string text;       ///< the values, and what would fit; without a full stop
  bool is_fault = false;  ///< false if the laser just leaves turns out
};

/// Returns how time_increment contradicts the period of the lines; nothing if it fits.
/// `scan_time_s` is the field of the message, or 0.
std::optional<TimingDoubt> timing_doubt(const LaserBeams& beams, double scan_time_s,
                                        double period_s);

}  // namespace ribbon_mapper
