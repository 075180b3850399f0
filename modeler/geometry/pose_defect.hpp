// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Largest coordinate of a position [m]: 25 times around the Earth. Doubles resolve 0.1 um there;
/// beyond, sums of what lasers measure lose their meaning.
constexpr double kMaxCoordinate_m = 1e9;

/// Returns what is wrong with a pose, such as "is not finite", or nothing if is_valid().
std::optional<std::string> find_defect(const Pose& pose);

}  // namespace ribbon_mapper
