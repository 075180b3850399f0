// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// Criteria for the planes of the model, and for the points that belong to them.
struct AssemblyConfig {
  /// Smallest number of ribbons of a plane.
  int min_ribbons = 10;

  /// Smallest seen area of a plane as built on the way [m2].
  double min_area_as_built_m2 = 0.1;

  /// Smallest seen area of a plane of the model, after merging [m2].
  double min_area_m2 = 0.5;

  /// A surface is curved, and no plane, if its radius is significantly smaller than this [m] and
  /// its sagitta larger than flat_within_m. Facets of columns of 0.24 m radius measure 2 to 5 per
  /// metre and 16 to 50 mm; flat boards stay below 0.7 per metre or 5 mm.
  double min_radius_m = 1.5;

  /// Largest sagitta of a plane over its own extent [m].
  double flat_within_m = 0.01;

  /// Number of standard errors by which a curvature must exceed 1 / min_radius_m.
  double curvature_sigmas = 3.0;

  /// Largest distance of a single point from the plane that it belongs to [m]: two to three
  /// standard deviations of a range.
  double on_plane_m = 0.04;

  /// Largest distance, within the plane, of a single point from where ribbons saw the plane [m].
  double beside_plane_m = 0.15;

  /// Number of lines that must pass a cell after the last line that ended in it, so that what was
  /// seen there is gone: as many as make a ribbon. 0: what was seen once stays. Counts only once
  /// there is a correction.
  int passed_lines = 3;
  /// Distance that a beam must go beyond a plane to have passed it [m]: more than the error of
  /// corrected poses and than the depth of mouldings.
  double passed_beyond_m = 0.15;
};

}  // namespace ribbon_mapper
