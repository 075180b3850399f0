// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace ribbon_mapper {

/// Returns a value with a fixed number of decimals.
inline std::string number(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// Returns an angle in degrees, without the unit.
inline std::string degrees(double angle_rad, int decimals = 1) {
  return number(angle_rad * 180.0 / M_PI, decimals);
}

/// Returns a count with its noun, such as "1 scan" or "2 scans".
inline std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace ribbon_mapper
