// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::sim {

class World;

/// From rest to rest over a length or an angle: constant acceleration, cruise, constant braking;
/// units are metres or radians.
struct Ramp {
  double way;
  double speed;  ///< that the way leaves time to reach
  double acceleration;
  double ramp_s;  ///< until the speed is reached
  double duration_s;

  Ramp(double way_, double max_speed, double acceleration_);
  double way_at(double time_s) const;
  double speed_at(double time_s) const;
};

/// Velocity of the base in its own frame.
struct Velocity {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
};

/// A way through the world: the robot turns on the spot towards the next waypoint, drives there
/// straight, and so on; at the end of a closed route it turns back to its first heading.
class Route {
 public:
  /// Reads YAML with `speed` [m/s], `turn_rate` [rad/s] and `waypoints` [[x, y], ...] [m, map], and
  /// `rest` [s], 0 if it is left out.
  /// Throws std::runtime_error naming the file and the key.
  static Route load(const std::string& path);

  /// Throws std::invalid_argument if a speed is outside the PR2's limits (1 m/s, 2 rad/s), or if
  /// there are less than two waypoints, or two following ones in the same place. The robot stands
  /// for `rest_s` before it starts (0 to 1000).
  Route(double speed_m_s, double turn_rate_rad_s, std::vector<Eigen::Vector2d> waypoints,
        double rest_s = 0.0);

  Time duration() const;
  double length_m() const { return length_m_; }
  double speed_m_s() const { return speed_m_s_; }
  /// The same way at another speed, the turn rate scaled alike up to the PR2's limit. Throws as the
  /// constructor does.
  Route at_speed(double speed_m_s) const;
  bool closed() const { return waypoints_.front() == waypoints_.back(); }
  const std::vector<Eigen::Vector2d>& waypoints() const { return waypoints_; }

  /// Where base_footprint is; before the start and after the end it stands.
  Pose T_map_base(Time time) const;
  Velocity velocity(Time time) const;

  /// Places along the whole route, at most 2 cm and 2 degrees apart.
  std::vector<Pose> poses_to_check() const;

 private:
  /// A turn on the spot or a straight drive.
  struct Leg {
    double start_s;
    Pose T_map_start;
    double yaw_rad;
    double turn_sign;  ///< of a turn, 0 for a drive
    Ramp ramp;
    Pose pose_at(double way) const;
  };
  Pose end_pose() const;
  void turn_to(double yaw_rad);
  void drive_to(const Eigen::Vector2d& target);
  const Leg& leg_at(double time_s) const;

  double speed_m_s_, turn_rate_rad_s_, rest_s_;
  std::vector<Eigen::Vector2d> waypoints_;
  std::vector<Leg> legs_;
  double length_m_ = 0.0;
  Eigen::Vector2d end_place_;  ///< end of the last leg
  double end_yaw_rad_, end_s_;
};

/// Throws std::runtime_error naming the place and what is hit if the PR2's body meets the world
/// somewhere on the route, looked at every 2 cm and 2 degrees.
void require_free(const World& world, const Route& route);

}  // namespace ribbon_mapper::sim
