// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/registration_config.hpp"
#include "slam/lines/relocaliser_config.hpp"

namespace ribbon_mapper::slam {

/// Settings of the estimate of the trajectory from odometry and ribbons.
struct EstimateConfig {
  /// Scale of the odometry's noise that is assumed at first, as a multiple of gmapping's for the
  /// PR2 (see OdometryNoise). Three: an error that is assumed too large costs some precision, one
  /// that is assumed too small loses the robot. The data correct it within a minute.
  double first_noise_scale = 3.0;

  /// The same for height, roll and pitch. One: what gmapping assumes in the plane. A level floor
  /// lowers it, ramps raise it.
  double first_spatial_scale = 1.0;

  /// Time between two adjustments of the newest poses [s]. The PR2 drives about a metre in it, so
  /// that a new part of the scene has come into view.
  double window_step_s = 3.0;

  /// Length of the window of poses that are adjusted together [s]: four steps, so that each pose is
  /// adjusted four times. It holds at least two sweeps of the laser.
  double window_s = 12.0;

  /// Distance from the poses of the window within which older lines are its context [m]. Farther
  /// away, a line of the PR2's laser has few points on a wall.
  double context_radius_m = 8.0;

  /// Largest number of lines in the context; of more, some are taken evenly. 1500 lines, 40 s of
  /// recording, show each plane many times.
  int max_context_lines = 1500;

  /// Association gates of the rounds of an adjustment: from twice the error that tracking leaves
  /// (5 cm in the simulator at a drift of 3) down to those of corrected poses.
  std::vector<AssociationGates> gates{{3.2, 0.12}, {2.5, 0.06}, {2.0, 0.03}};

  /// Gauss-Newton steps in a round. The second removes the linearisation error of the first.
  int steps_per_round = 2;

  RelocaliserConfig relocaliser;  ///< being lost, and found
};

/// All settings that the estimate depends on.
struct EstimateSettings {
  EstimateConfig estimate;          ///< its own
  RegistrationConfig registration;  ///< matching of ribbons with landmarks
  SharedSettings shared;            ///< those of other stages

  /// Returns the noise of ranges.
  RangeNoise range_noise() const { return {shared.range_sigma_m, registration.shared_sigma_ratio}; }
};

/// Returns the settings of an estimate beside a modeler.
inline EstimateSettings estimate_settings(const ModelerConfig& modeler) {
  return {
      {},
      modeler.registration,
      {modeler.scan.range_sigma_m, modeler.association.corrected, modeler.surface.bridged_gap_m}};
}

}  // namespace ribbon_mapper::slam
