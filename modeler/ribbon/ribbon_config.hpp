// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How surfels become ribbons (sections 4.1 and 4.2 of the paper).
struct RibbonConfig {
  /// Half length along the line of the neighbourhood of a normal [m]. With three lines, 0.15 m
  /// keeps the error of a normal at 1 to 4 degrees from 1 to 10 m for range_sigma_m = 0.01.
  double neighbourhood_m = 0.15;

  /// Size of a cell of the orientation grid [deg]; the cells of all rows have about this width.
  double grid_cell_deg = 5.0;

  /// Normals within this angle of a cluster's mean belong to it [deg]: about three times the error
  /// of a surfel's normal.
  double cluster_angle_deg = 12.0;

  /// A surfel votes with its area (eq. 2), but never with more than this [m2]: far surfels are
  /// large and their normals weak.
  double area_cap_m2 = 0.01;

  /// Least area of the surfels of an orientation cluster [m2].
  double min_cluster_area_m2 = 0.003;

  /// Clusters are split where the distances from the sensor's origin leave a gap of this [m].
  double distance_gap_m = 0.06;

  /// Points this many range_sigma_m from a ribbon's plane do not belong to it.
  double outlier_sigmas = 2.5;

  /// A ribbon's middle line may lie this many standard errors (plus spurious_slack_m) off the plane
  /// of all three lines: more, and the lines straddle an edge.
  double spurious_sigmas = 4.0;
  double spurious_slack_m = 0.002;

  /// Least angle between a ribbon's plane and the beam to its middle [deg]: mixed pixels between
  /// two depths make veils that lie along the beams. A floor is seen at 4 degrees from 15 m.
  double min_grazing_angle_deg = 4.0;

  /// Least length [m] and number of points of a ribbon.
  double min_length_m = 0.10;
  int min_points = 6;

  /// Points of a ribbon are kept for the cells as means over this length [m]: half of a cell. Over
  /// a whole one, small planes lose up to a tenth of their seen area.
  double sample_length_m = 0.025;
};

}  // namespace ribbon_mapper
