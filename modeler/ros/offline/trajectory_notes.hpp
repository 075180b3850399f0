// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Returns whether the base stands still: the localisation then cannot drift from line to line.
bool stands_still(const std::vector<StampedPose>& trajectory);

/// Returns the largest way that a pose has moved [m]. Both have the poses of the same lines.
double largest_move_m(const std::vector<StampedPose>& before,
                      const std::vector<StampedPose>& after);

/// Returns a warning if a trajectory leaves out more than a twentieth of the time of the lines,
/// which are not empty.
std::optional<std::string> lacking_time(const std::vector<StampedPose>& lines,
                                        const std::vector<StampedPose>& corrected);

}  // namespace ribbon_mapper
