// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper::slam {

/// Settings for noticing a robot that is lost, and for finding it.
///
/// Shares are those of the length of ribbons on walls. In the simulated apartment, 0.92 to 0.99 of
/// what was in view for six seconds was known on known ground, and at most 0.02 was seen through
/// it. Six seconds after a slip of 20 degrees, these were 0.00 and 0.18.
struct RelocaliserConfig {
  /// Time of the newest lines that are looked for [s]: two steps of the window. The second window
  /// after a slip then holds no line from before it, and two sweeps of the laser.
  double query_s = 6.0;

  double known_share = 0.9;     ///< ground is known if so much of it is, and
  double pierced_share = 0.05;  ///< no more than this is seen through known walls

  /// Largest distance of a move where it begins [m]: the PR2 drives 1 m/s, and is pushed for 1.5 s.
  /// Rooms that look alike are farther apart.
  double radius_m = 1.5;
  /// Largest angle of a move [deg]: a push while the robot turns by 0.6 rad/s for two seconds is 69
  /// degrees. Rooms that are turned by 90 degrees look alike.
  double angle_deg = 75.0;
  /// The same for drift: standard deviations of the odometry since the place was seen. Three, as in
  /// other gates.
  double drift_sigmas = 3.0;

  // Moves below these are not tried. Lower values cost time: the cost of the histories decides.
  double least_score = 0.3;  ///< share of the points on known walls, in the plan
  double least_known = 0.5;  ///< share of what is in view that is known after a move: most of it
  double least_known_again = 0.3;  ///< the same, if the look before has found the move as well
  double least_gain = 0.1;         ///< the same, less what is known without the move
  double second_share = 0.9;       ///< a move is not clear if another one scores so much of it

  /// Time in which a move may turn out wrong [s]: by then the robot has seen a room.
  double probation_s = 60.0;
};

}  // namespace ribbon_mapper::slam
