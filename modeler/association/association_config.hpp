// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// Within these a ribbon may belong to a plane (section 4.3): two sigma of what sensor and poses
/// do.
struct AssociationGates {
  double angle_deg;   ///< between the ribbon and the plane
  double distance_m;  ///< of the ribbon's centroid from the plane
};

/// How ribbons become planes (sections 4.3 and 6 of the paper).
struct PlaneMapConfig {
  /// On the way, with the poses of a SLAM: the tolerances learned in section 5.1, moving robot.
  AssociationGates slam{3.2, 0.25};

  /// After a correction, with poses that agree all along the way: three sigma of a range at its
  /// noisiest (UTM-30LX: 0.018 m), and what that leaves of the normal of a small plane.
  AssociationGates corrected{2.0, 0.03};

  /// Gaps of at most this are bridged: a wall with a door in it is one plane [m]. Also how far from
  /// a plane's ribbons another ribbon may lie to join it.
  double bridged_gap_m = 1.0;

  /// Gaps of at most this are those between scan lines [m].
  double stripe_gap_m = 0.3;

  /// After each line, a model has no more ribbons than this (0: no limit); a ribbon with all that
  /// it brings takes 400 to 500 bytes. When it is reached, an eighth of them is left out, from
  /// where most see the same: the error of a plane there grows as the root of what its ribbons
  /// decreased by.
  int max_ribbons = 1'000'000;

  /// Side of the cells of a plane's grid [m].
  double cell_size_m = 0.05;

  /// A hypothesis is confirmed from this many ribbons on, and as built on the way from this seen
  /// area on.
  int confirmed_ribbons = 10;
  double confirmed_area_m2 = 0.1;

  /// Least seen area of a plane after the final merging [m2].
  double min_area_m2 = 0.5;

  /// A surface is curved, thus no plane, if its radius is smaller than this [m] by so many standard
  /// errors, and its arc higher than this over its extent [m]. Facets of columns of 0.24 m measure
  /// 2 to 5 per metre and 16 to 50 mm, flat boards below 0.7 per metre or 5 mm: their edges pull.
  double min_radius_m = 1.5;
  double flat_within_m = 0.01;
  double curvature_sigmas = 3.0;

  /// A single point lies on a plane if it is within three sigma of a range of it [m], and not much
  /// further than this from where ribbons have seen it [m]. So bevels (planes across a corner, all
  /// of whose points lie on other planes) are told, and points of no ribbon find their plane.
  double on_plane_m = 0.04;
  double beside_plane_m = 0.15;
};

}  // namespace ribbon_mapper
