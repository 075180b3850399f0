// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// Degrees in one radian.
constexpr double kDegreesPerRadian = 180.0 / 3.14159265358979323846;

/// Returns an angle in degrees, given in radians.
inline double to_degrees(double angle_rad) { return angle_rad * kDegreesPerRadian; }

}  // namespace ribbon_mapper
