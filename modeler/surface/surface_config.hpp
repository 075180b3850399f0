// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// The grid of cells on a plane (section 6 of the paper), and which gaps in it are bridged.
struct SurfaceConfig {
  /// Side of a cell [m]. At 5 m, neighbouring beams of the UTM-30LX are 2 cm apart.
  double cell_size_m = 0.05;

  /// Largest gap between scan lines on one surface [m]. Such gaps are closed in outlines, meshes
  /// and markers; wider ones, such as doors, stay open.
  double stripe_gap_m = 0.3;

  /// Largest distance of an outline from the boundary of the seen cells [m]. Half the diagonal of a
  /// cell, so that the stairs of cells along an oblique edge become one line.
  double outline_tolerance_m = 0.036;

  /// Largest gap within one plane [m]: a wall with a door in it is one plane. A ribbon joins a
  /// plane only if it lies no further than this from the plane's other ribbons.
  double bridged_gap_m = 1.0;
};

}  // namespace ribbon_mapper
