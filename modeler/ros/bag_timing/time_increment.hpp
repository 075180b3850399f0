// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Returns the time increment of a laser that turns once in `period_s`, at a constant speed.
inline double time_increment_of(double period_s, double angle_increment_rad) {
  return period_s * std::abs(angle_increment_rad) / (2.0 * M_PI);
}

/// Returns true if a laser that takes a line in every period can have this time increment. The line
/// takes at least the part of a turn that it covers, and at most the whole period. A time increment
/// of 0 means that it is not known, which is possible.
inline bool fits_period(double time_increment_s, const LaserBeams& beams, double period_s) {
  constexpr double tolerance = 0.1;
  const double steps = static_cast<double>(beams.ranges_m.size()) - 1.0;
  if (time_increment_s == 0.0 || period_s <= 0.0 || steps < 1.0) return true;
  return time_increment_s >=
             (1.0 - tolerance) * time_increment_of(period_s, beams.angle_increment_rad) &&
         time_increment_s * steps <= (1.0 + tolerance) * period_s;
}

}  // namespace ribbon_mapper
