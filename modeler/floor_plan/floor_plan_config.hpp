// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How walls, doors and rooms become a floor plan.
struct FloorPlanConfig {
  /// Largest thickness of a wall [m]: of masonry of 36.5 cm (DIN 4172) with insulation and plaster.
  /// Two faces further apart are two walls.
  double greatest_thickness_m = 0.5;

  /// Least thickness of a wall [m]. The thinnest partition has 5 cm (DIN 4103), a board 2 cm; faces
  /// that are closer are errors of the model.
  double least_thickness_m = 0.02;

  /// Largest angle between the two faces of a wall [deg]: that between walls which were built
  /// parallel. A wedge of 5 degrees over a room of 4 m is 35 cm thicker at one end.
  double parallel_deg = 5.0;

  /// Largest gap between faces that meet in a corner [m]: two cells, since each face ends at a
  /// cell.
  double joint_m = 0.1;

  /// Largest length of stray cells beyond an outer corner [m], as SurfaceConfig::stripe_gap_m: the
  /// lines resolve nothing that is narrower.
  double overshoot_m = 0.3;

  /// Least length of a wall of which one face was seen [m], as two cells.
  double least_length_m = 0.1;

  /// Depth of such a wall where it bounds a room [m], as RoomConfig::wall_m.
  double unseen_depth_m = 0.08;

  /// Largest gap in a wall that ends no room [m]: less than the narrowest door has, see
  /// LabelConfig::least_door_width_m. Something hides the wall there.
  double bridged_m = 0.5;

  /// Largest gap in a wall that furniture hides, if no floor was seen in it [m]: the width of a
  /// wardrobe with four doors, as LabelConfig::greatest_door_width_m.
  double hidden_m = 2.3;

  /// Heights above the floor between which a wall must be open to be walked through [m]: above
  /// skirting boards and thresholds, below lintels.
  double band_begin_m = 0.2;
  double band_end_m = 1.8;  ///< upper end of the band

  /// Least share of the floor behind a gap in a wall that makes it an opening. Half, and a margin
  /// for what furniture hides.
  double through_share = 0.6;
};

}  // namespace ribbon_mapper
