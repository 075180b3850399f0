// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Outer boundary of the seen cells, with gaps up to `bridged_gap_m` closed, simplified to a cell's
/// side; counter-clockwise about the normal, not closed.
std::vector<Eigen::Vector3d> outline_of(const Plane& plane, double bridged_gap_m);

}  // namespace ribbon_mapper
