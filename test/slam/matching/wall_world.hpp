// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "slam/matching/level_scan.hpp"

namespace ribbon_mapper::slam {

/// A wall from one point to another [m].
struct Wall {
  double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
};

/// Walls that a level laser sees, in closed form.
class WallWorld {
 public:
  explicit WallWorld(std::vector<Wall> walls) : walls_(std::move(walls)) {}

  /// A room of 8 x 5 m about the origin with a cupboard: no turn maps it onto itself.
  static WallWorld room();
  /// A square room about the origin, 6 m wide: a quarter turn maps it onto itself.
  static WallWorld square();
  /// Two walls along x, 2 m apart, without an end in sight.
  static WallWorld corridor();
  /// Four corridors around a block of 14 x 10 m, with pilasters at uneven places.
  static WallWorld ring();

  /// Returns the range at which a ray from a point meets a wall; infinity if it does not.
  double range_m(double x_m, double y_m, double angle_rad) const;
  /// Returns the beams of a laser at a pose: half a circle, or a whole one; 1 degree apart.
  LaserBeams beams(const PlanarPose& T_world_laser, bool is_whole = false) const;
  /// Returns the points of such a laser.
  LevelScan scan(const PlanarPose& T_world_base, double stamp_s = 1.0, bool is_whole = false) const;

 private:
  std::vector<Wall> walls_;
};

/// Returns the poses of a robot that drives along the middle of WallWorld::ring(), `laps` times.
std::vector<PlanarPose> ring_drive(double laps, double step_m);

/// Returns poses of odometry that drifts: each step is longer by a share and turns by so much.
std::vector<PlanarPose> drifting(const std::vector<PlanarPose>& poses, double longer,
                                 double turn_rad_per_m);

}  // namespace ribbon_mapper::slam
