// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// Returns of one scan line that belong to no ribbon: too few side by side for a normal, or seen by
/// this line alone. They do not say where a plane is, only how far a plane was seen.
struct StrayPoints {
  std::uint32_t pose = 0;  ///< acquisition pose: index into the trajectory
  Eigen::Vector3f sensor = Eigen::Vector3f::Zero();  ///< in the frame of the acquisition pose
  std::vector<RibbonSample> samples;
};

}  // namespace ribbon_mapper
