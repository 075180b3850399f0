// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/association/association_config.hpp"

namespace ribbon_mapper {

/// Settings of the registration of lines between corrected poses; see registered_poses().
struct RegistrationConfig {
  /// False: lines between corrected poses follow the odometry alone, corrected linearly.
  bool enabled = true;

  /// Rounds in which plane landmarks and poses are estimated in turn. Each round localises more
  /// lines from the ends of a segment inwards; segments of some ten metres settle within three.
  int rounds = 3;

  /// Forward-backward passes over each segment in a round. The second pass matches ribbons where
  /// the first one has localised the lines.
  int passes_per_round = 2;

  /// Gauss-Newton steps on landmarks and poses together in a round. The second step removes the
  /// linearisation error of the first one.
  int adjustments_per_round = 2;

  /// Ribbons of independent support that a hypothesis needs to become a landmark: as many as
  /// confirm a plane. Ribbons of the one segment that contributes the most do not count.
  int min_ribbons = 10;

  /// Part of a range's standard deviation that all points of a ribbon share, such as the bias of a
  /// surface's reflectance: a quarter. Averaging does not reduce it.
  double shared_sigma_ratio = 0.25;

  /// Largest tilt of a ribbon across its direction from a landmark that does not count [deg]: the
  /// moving robot's tolerance of the paper (section 5.1). A larger one adds to the Mahalanobis
  /// distance by the noise of ranges, odometry and pose.
  double max_tilt_across_deg = 3.2;

  /// Largest squared Mahalanobis distance of a ribbon from its landmark, in distance and tilt.
  /// With two degrees of freedom, chance exceeds 11.8 once in 365 times (three sigma).
  double max_chi_square = 11.8;

  /// Least lead of the best landmark over the second best in squared Mahalanobis distance. By 4 it
  /// is e^2 times as likely; below, the ribbon is ambiguous and matches neither.
  double min_chi_square_lead = 4.0;

  /// Residual that has half its weight in the least squares [sigmas] (Cauchy's weight function).
  /// Noise beyond two sigmas is rare, wrong matches are not.
  double robust_sigmas = 2.0;

  /// A line is localised if odometry alone places its ribbons within this part of the association
  /// gate's distance (one sigma). Half: the gate is two sigmas wide.
  double start_gate_ratio = 0.5;

  /// The same for a line that has been registered. A quarter: its error is shared with the
  /// landmarks that it was registered to.
  double final_gate_ratio = 0.25;
};

/// Settings of other stages that the registration has to agree with.
struct SharedSettings {
  double range_sigma_m;    ///< standard deviation of one range [m], see ScanConfig
  AssociationGates gates;  ///< for ribbons and planes after a correction
  double bridged_gap_m;    ///< how far from a plane's ribbons another may lie to join it [m]
};

}  // namespace ribbon_mapper
