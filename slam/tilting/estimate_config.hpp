// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/registration/registration_config.hpp"

namespace ribbon_mapper::slam {

/// Settings of the estimate of the trajectory from odometry and ribbons.
struct EstimateConfig {
  /// Scale of the odometry's noise that is assumed at first, as a multiple of gmapping's for the
  /// PR2. Three: an error that is assumed too large costs little, one too small loses the robot.
  double first_noise_scale = 3.0;

  /// Time between two adjustments of the last poses [s]: at the PR2's speed, the robot has moved by
  /// about a metre and a new part of the scene has come into view.
  double window_step_s = 3.0;
  /// Length of the window of poses that are adjusted together [s]. Four steps, so that each line is
  /// adjusted four times, and longer than two sweeps of the laser.
  double window_s = 12.0;
  /// Distance from the window within which older lines count as its surroundings [m]: beyond, the
  /// PR2's laser sees a room's planes with few points.
  double radius_m = 8.0;
  /// Largest number of older lines in a window; more are taken evenly.
  int max_context_lines = 1500;

  /// Association gates of the rounds of an adjustment, from the first to the last: from a few times
  /// the error that tracking leaves to the gates of corrected poses.
  std::vector<AssociationGates> window_gates{{3.2, 0.12}, {2.5, 0.06}, {2.0, 0.03}};
  /// The same for the adjustment of the whole trajectory.
  std::vector<AssociationGates> final_gates{{3.2, 0.12}, {2.5, 0.06}, {2.0, 0.03}};
  /// Gauss-Newton steps in a round. The second step removes the linearisation error of the first.
  int steps_per_round = 2;
};

/// Settings of other stages that the estimate has to agree with.
struct EstimateSettings {
  EstimateConfig estimate;          ///< its own
  RegistrationConfig registration;  ///< matching of ribbons with landmarks
  SharedSettings shared;            ///< ranges, gates and reach
};

}  // namespace ribbon_mapper::slam
