// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "modeler/chain/matrix6.hpp"

namespace ribbon_mapper {

/// How precisely the poses of a trajectory are known, in four numbers.
struct PosePrecision {
  double position_m_median = 0.0;    ///< standard deviation of a position, the median of all poses
  double position_m_largest = 0.0;   ///< the same, of the pose that is known worst
  double heading_deg_median = 0.0;   ///< standard deviation of a heading, the median of all poses
  double heading_deg_largest = 0.0;  ///< the same, of the pose that is known worst
};

/// Returns the precision that covariances of poses state; zeros without any. The standard deviation
/// of a position is the root of the mean squared distance from the true one, in three dimensions.
/// The heading is the rotation about the frame's z axis.
PosePrecision precision_of(const std::vector<Matrix6>& covariances);

/// Returns the numbers with their names in summaries, in the order of the members.
std::array<std::pair<const char*, double>, 4> named_sigmas(const PosePrecision& precision);

}  // namespace ribbon_mapper
