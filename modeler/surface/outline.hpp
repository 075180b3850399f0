// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns the outer boundary of the largest piece of the seen cells, in the frame of the plane
/// [m].
///
/// Gaps up to `bridged_gap_m` are closed first. The boundary is simplified with a tolerance of one
/// cell. It is counter-clockwise about the normal and does not repeat its first point.
std::vector<Eigen::Vector3d> outline_of(const Plane& plane, double bridged_gap_m);

}  // namespace ribbon_mapper
