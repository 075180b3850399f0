// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How maps for robots are made: voxels that are free or occupied, and a level map for navigation.
struct MapsConfig {
  /// Side of a voxel and of a cell of the level map [m]: that of a plane's cells. It is doubled
  /// until an OctoMap holds the model (1600 m from its origin), and memory a level map of 16
  /// million cells (200 m by 200 m).
  double voxel_m = 0.05;

  /// Distance from a surface at which the beams to it stop to carve [m]: 2.5 standard deviations of
  /// a range. Noise then frees nothing behind the surface.
  double surface_margin_m = 0.025;

  /// Lowest height above the floor at which something is an obstacle [m]: two voxels, the one of
  /// the floor and one for its unevenness. Sills of doors are lower.
  double obstacle_min_m = 0.10;

  /// Largest height above the floor at which something is an obstacle [m]: that of a PR2 with its
  /// torso up is 1.645 m.
  double obstacle_max_m = 1.65;

  /// Smallest part of a column between these heights that beams must have passed for its cell to be
  /// free. With less, nobody knows what stands there.
  double min_free_share = 0.5;
};

}  // namespace ribbon_mapper
