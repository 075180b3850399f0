// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/map/plane.hpp"

namespace ribbon_mapper {

/// Bend of a surface and its standard error [1/m].
struct Curvature {
  double bend = 0.0;   ///< larger principal curvature, absolute
  double sigma = 0.0;
};

/// Of the quadric that fits the means of a plane's cells best: tells a facet of a column from a
/// plane. Sigma is infinite if there are too few cells to tell.
Curvature curvature_of(const Plane& plane);

}  // namespace ribbon_mapper
