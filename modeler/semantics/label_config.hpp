// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// The limits of the rules that label planes. Heights are above the floor below.
///
/// They are sizes of buildings and of a robot, not of the laser. Each is well away from what it
/// separates; how far a plane is from them becomes its confidence.
struct LabelConfig {
  /// Largest tilt of a level plane [deg]. Floors drain at up to 2 % (1.1 degrees); ramps for people
  /// rise by up to 6 % (3.4 degrees, DIN 18040).
  double level_deg = 2.0;

  /// Largest lean of an upright plane [deg]. Walls lean by less, roofs by more.
  double upright_deg = 30.0;

  /// Largest distance of the robot's footprint from what it drives on, and of two floors of one
  /// level [m]. Less than the lowest step, more than a threshold or a carpet.
  double floor_step_m = 0.06;

  /// Lowest ceiling or roof over people's heads [m]. The clear height of a door (DIN 18101: 1.985
  /// m) less the width of two cells.
  double head_height_m = 1.9;

  /// Largest gap between a wall and the ceiling [m]: its top row of cells is often not seen.
  /// Furniture leaves more, or nothing.
  double ceiling_gap_m = 0.25;

  /// Least height of a wall whose ceiling is not seen [m]: the clear height of a door (DIN 18101:
  /// 1.985 m) less half a cell.
  double wall_height_m = 1.96;

  /// Least width of a wall that is no higher than a door leaf [m]; a leaf has 1.11 m at most (DIN
  /// 18101).
  double wall_width_m = 1.2;

  /// Height from which on no piece of furniture is expected [m], if the ceiling is not seen.
  double furniture_height_m = 2.3;

  /// Largest depth of furniture in front of a wall [m]. Less than a corridor's width (DIN
  /// 18040: 1.2 m).
  double furniture_depth_m = 1.1;

  /// Height by which a wall must rise above what stands in front of it [m].
  double rise_behind_m = 0.2;

  /// Least width of a door opening and leaf [m]: that of the narrowest leaf (DIN 18101: 0.61 m)
  /// less a cell.
  double least_door_width_m = 0.55;

  /// Largest width of a door leaf [m]: the widest (DIN 18101: 1.11 m), and two cells.
  double greatest_leaf_width_m = 1.2;

  /// Least width of a wall on both sides of a door opening whose lintel was not seen [m]. Two
  /// pilasters on both sides of a corridor are narrower.
  double least_flank_m = 0.4;

  /// Largest width of a door opening [m]: of two leaves.
  double greatest_door_width_m = 2.3;

  /// Least height of a door leaf [m]: the clear height of a door less two cells.
  double least_leaf_height_m = 1.85;

  /// Largest height of a door leaf [m].
  double greatest_leaf_height_m = 2.25;

  /// Largest distance of a leaf's edge from the jamb where it hangs [m].
  double hinge_gap_m = 0.15;

  /// Largest depth of a door's reveal, which is that of its wall [m].
  double reveal_depth_m = 0.5;

  /// Spread of the sizes above among buildings [m], and what a boundary of cells is uncertain by.
  double size_sigma_m = 0.1;

  /// The same for tilts [deg]; the plane's own uncertainty is added.
  double tilt_sigma_deg = 0.5;
};

}  // namespace ribbon_mapper
