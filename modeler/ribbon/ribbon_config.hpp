// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How surfels become ribbons (sections 4.1 and 4.2 of the paper).
struct RibbonConfig {
  /// Half the length of a normal's neighbourhood along the line [m]. With three lines and a range
  /// sigma of 0.01 m, 0.15 m keeps the error of a normal at 1 to 4 degrees from 1 to 10 m.
  double neighbourhood_m = 0.15;

  /// Width of a cell of the orientation grid [deg]. The cells of all rows have about this width.
  double grid_cell_deg = 5.0;

  /// Largest angle between a normal and the mean of its cluster [deg]: about three times the error
  /// of a surfel's normal.
  double cluster_angle_deg = 12.0;

  /// Largest area with which a surfel votes and weighs (eq. 2) [m2]. Distant surfels are large and
  /// their normals weak.
  double area_cap_m2 = 0.01;

  /// Smallest area of the surfels of an orientation cluster [m2].
  double min_cluster_area_m2 = 0.003;

  /// Smallest gap between distances from the sensor at which a cluster is split [m].
  double distance_gap_m = 0.06;

  /// Largest distance of a point from its ribbon's plane, in standard deviations of the point's
  /// error across the plane.
  double outlier_sigmas = 2.5;

  /// Smallest angle at which a line of returns is divided into two ribbons [deg]: that of the gate
  /// AssociationConfig::corrected, as less is one plane to it.
  double min_bend_deg = 2.0;

  /// Largest offset of a ribbon's middle line from the plane of all three lines, in standard errors
  /// beyond edge_slack_m. With more, the lines straddle an edge.
  double edge_sigmas = 4.0;
  /// Part of that offset that is always tolerated [m].
  double edge_slack_m = 0.002;

  /// Smallest angle between a ribbon's plane and the beam to its middle [deg]. Mixed pixels form
  /// surfaces along the beams. A floor is seen at 4 degrees from 15 m.
  double min_grazing_angle_deg = 4.0;

  /// Smallest length of a ribbon [m].
  double min_length_m = 0.10;
  /// Smallest number of points of a ribbon.
  int min_points = 6;

  /// Length over which a ribbon's points are averaged for the cells [m]: half a cell. With a whole
  /// cell, small planes lose up to a tenth of their seen area.
  double sample_length_m = 0.025;
};

}  // namespace ribbon_mapper
