// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace ribbon_mapper {

/// One degree [rad].
constexpr double kDegree = M_PI / 180.0;

/// Returns an angle in degrees, given in radians.
inline double to_degrees(double angle_rad) { return angle_rad / kDegree; }

}  // namespace ribbon_mapper
