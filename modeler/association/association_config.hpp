// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// The largest differences at which a ribbon may still belong to a plane (section 4.3 of the
/// paper): two standard deviations of the errors of sensor and poses together.
struct AssociationGates {
  double angle_deg;   ///< largest angle between ribbon and plane
  double distance_m;  ///< largest distance of the ribbon's centroid from the plane
};

/// Gates of the association of ribbons with planes (section 4.3 of the paper).
struct AssociationConfig {
  /// Gates while the model is built with the poses of a live SLAM. The values are the tolerances
  /// that section 5.1 learned for the moving robot.
  AssociationGates slam{3.2, 0.25};

  /// Gates after a correction, when all poses are consistent. The distance is three standard
  /// deviations of the UTM-30LX at its noisiest (0.018 m, rounded down to 3 cm with the mean of a
  /// ribbon's points); the angle is what that error leaves of a small plane's normal.
  AssociationGates corrected{2.0, 0.03};

  /// Smallest number of ribbons between two checkpoints of a corrected model (0: no checkpoints,
  /// every correction associates all ribbons). A robot sees as many in about six seconds: half of
  /// what an estimate of the trajectory usually revises. Memory is that of what changes meanwhile.
  int checkpoint_ribbons = 512;
};

}  // namespace ribbon_mapper
