// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/time_increment.hpp"

#include <cmath>
#include <cstdio>

namespace ribbon_mapper {
namespace {

double steps_of(const LaserBeams& beams) {
  return static_cast<double>(beams.ranges_m.size()) - 1.0;
}

/// Returns the fields that are compared, in words.
std::string facts(const LaserBeams& beams, double scan_time_s, double period_s) {
  char text[200];
  std::snprintf(text, sizeof text,
                "time_increment is %.2f us, so that lines last %.1f ms, scan_time is %.1f ms, and "
                "lines come every %.1f ms",
                1e6 * beams.time_increment_s, 1e3 * steps_of(beams) * beams.time_increment_s,
                1e3 * scan_time_s, 1e3 * period_s);
  return text;
}

}  // namespace

double time_increment_of(double period_s, double angle_increment_rad) {
  return period_s * std::abs(angle_increment_rad) / (2.0 * M_PI);
}

bool fits_period(double time_increment_s, const LaserBeams& beams, double period_s) {
  constexpr double tolerance = 0.1;
  const double steps = steps_of(beams);
  if (time_increment_s == 0.0 || period_s <= 0.0 || steps < 1.0) return true;
  return time_increment_s >=
             (1.0 - tolerance) * time_increment_of(period_s, beams.angle_increment_rad) &&
         time_increment_s * steps <= (1.0 + tolerance) * period_s;
}

bool leaves_turns_out(const LaserBeams& beams, double period_s) {
  constexpr double shortest_turn_s = 0.01, tolerance = 0.05;
  const double turn_s = beams.time_increment_s * 2.0 * M_PI / std::abs(beams.angle_increment_rad);
  if (!(turn_s >= shortest_turn_s)) return false;
  const double turns = period_s / turn_s;
  return std::round(turns) >= 2.0 && std::abs(turns - std::round(turns)) <= tolerance;
}

std::optional<TimingDoubt> timing_doubt(const LaserBeams& beams, double scan_time_s,
                                        double period_s) {
  const double increment_s = beams.time_increment_s;
  if (fits_period(increment_s, beams, period_s)) return std::nullopt;
  const std::string values = facts(beams, scan_time_s, period_s);
  const bool is_one_of_many = scan_time_s > 0.0 && scan_time_s < 0.75 * period_s &&
                              fits_period(increment_s, beams, scan_time_s);
  if (is_one_of_many || leaves_turns_out(beams, period_s))
    return TimingDoubt{values + ": the laser leaves turns out", false};
  const bool is_longer = steps_of(beams) * increment_s > period_s;
  char advice[100];
  std::snprintf(advice, sizeof advice,
                ". A constant turn would need a time_increment of %.2f us: correct the driver",
                1e6 * time_increment_of(period_s, beams.angle_increment_rad));
  return TimingDoubt{
      values + (is_longer ? ": lines last longer than their period" : ": these do not fit") +
          advice,
      true};
}

}  // namespace ribbon_mapper
