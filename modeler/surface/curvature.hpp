// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// How far a surface is from being flat.
struct Curvature {
  double bend = 0.0;       ///< larger principal curvature, absolute [1/m]
  double sigma = 0.0;      ///< standard error of the bend [1/m]
  double sagitta_m = 0.0;  ///< height of the bend's arc over the surface's extent along it
};

/// Of the quadric that fits the means of a plane's cells best: tells a facet of a column from a
/// plane. Sigma is infinite if there are too few cells to tell.
Curvature curvature_of(const Plane& plane);

/// Four fifths of a plane's well-seen cells have their mean within this of the plane [m]; nothing
/// if few cells are well seen. Noise averages out in a cell, steps between things side by side do
/// not.
std::optional<double> cell_scatter_m(const Plane& plane);

}  // namespace ribbon_mapper
