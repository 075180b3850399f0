// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// The curvature of a surface.
struct Curvature {
  double bend = 0.0;       ///< absolute value of the larger principal curvature [1/m]
  double sigma = 0.0;      ///< standard error of `bend` [1/m]
  double sagitta_m = 0.0;  ///< height of the arc of this curvature over the surface's extent
};

/// Returns the curvature of the quadric that fits the mean distances of a plane's cells best.
/// Serves to distinguish a facet of a column from a plane. Curvature::sigma is infinite for too few
/// cells.
Curvature curvature_of(const Plane& plane);

/// Returns the distance from the plane within which the means of four fifths of its well-seen cells
/// lie [m], or nothing if few cells are well seen. Noise averages out within a cell; steps between
/// adjacent objects do not.
std::optional<double> cell_scatter_m(const Plane& plane);

}  // namespace ribbon_mapper
