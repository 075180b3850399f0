// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/tour/ground_profile.hpp"

namespace ribbon_mapper::sim {

class World;

/// A motion from rest to rest over a length or an angle: constant acceleration, cruise, constant
/// braking. Units are metres or radians.
struct Ramp {
  double way;           ///< length of the motion
  double speed;         ///< highest speed that is reached
  double acceleration;  ///< at the start; the braking is as strong
  double ramp_s;        ///< time until the highest speed is reached
  double duration_s;    ///< of the whole motion

  /// Plans the fastest motion over `way_` within the limits.
  Ramp(double way_, double max_speed, double acceleration_);
  /// Returns the way covered after `time_s`.
  double way_at(double time_s) const;
  /// Returns the speed after `time_s`, 0 outside the motion.
  double speed_at(double time_s) const;
};

/// Velocity of the base in its own frame.
struct Velocity {
  double forward_m_s = 0.0;  ///< along x
  double turn_rad_s = 0.0;   ///< about z
};

/// A way through the world. The robot turns on the spot towards the next waypoint, drives straight
/// to it, and so on. At the end of a closed route it turns back to its first heading. On ramps, it
/// has the height and the pitch of the ground; its ways and speeds are those in the plane.
class Route {
 public:
  /// Reads YAML with `speed` [m/s], `turn_rate` [rad/s], `waypoints` [m, map] and optionally `rest`
  /// [s]. A waypoint is [x, y], or [x, y, z] with the height of the ground. Throws
  /// std::runtime_error that names the file and the key.
  static Route load(const std::string& path);

  /// Plans the motion; the robot rests for `rest_s` (0 to 1000) before it starts. Throws
  /// std::invalid_argument if a speed exceeds the PR2's limits (1 m/s, 2 rad/s) or is below 0.001.
  /// Also throws it for fewer than two waypoints, two successive ones in the same place, and a way
  /// of more than 10 km or 4 hours. `heights_m` has the ground's height at each waypoint; empty is
  /// level ground. Throws as well for a slope above 0.1, and for a turn that is not on level
  /// ground.
  Route(double speed_m_s, double turn_rate_rad_s, std::vector<Eigen::Vector2d> waypoints,
        double rest_s = 0.0, std::vector<double> heights_m = {});

  /// Returns the time from the beginning of the rest to the end of the motion.
  Time duration() const;
  /// Returns the length of the way.
  double length_m() const { return length_m_; }
  /// Returns the speed of the drives.
  double speed_m_s() const { return speed_m_s_; }
  /// Returns the same way at another speed. The turn rate is scaled by the same factor, up to the
  /// PR2's limit. Throws as the constructor does.
  Route at_speed(double speed_m_s) const;
  /// Returns true if the last waypoint equals the first.
  bool closed() const { return waypoints_.front() == waypoints_.back(); }
  /// Returns the waypoints [m, map].
  const std::vector<Eigen::Vector2d>& waypoints() const { return waypoints_; }

  /// Returns true if all of the ground is at height 0.
  bool is_level() const { return ground_.is_level(); }

  /// Returns the pose of base_footprint, which stands still before the start and after the end.
  Pose T_map_base(Time time) const;
  /// Returns the velocity of the base.
  Velocity velocity(Time time) const;

  /// Returns poses along the whole route, at most 2 cm and 2 degrees apart.
  std::vector<Pose> poses_to_check() const;

 private:
  /// A turn on the spot or a straight drive.
  struct Leg {
    double start_s;
    Pose T_map_start;
    double yaw_rad;
    double turn_sign;    ///< -1 or 1 for a turn, 0 for a drive
    double start_way_m;  ///< way of the route before it
    Ramp ramp;
    Pose pose_at(double way) const;  ///< on level ground
  };
  void require_within_limits() const;
  void lay_ground();
  Pose pose_on_ground(const Leg& leg, double way) const;
  Pose end_pose() const;
  void turn_to(double yaw_rad);
  void drive_to(const Eigen::Vector2d& target);
  const Leg& leg_at(double time_s) const;

  double speed_m_s_, turn_rate_rad_s_, rest_s_;
  std::vector<Eigen::Vector2d> waypoints_;
  std::vector<double> heights_m_;  ///< of the ground at the waypoints, or empty
  GroundProfile ground_;
  std::vector<Leg> legs_;
  double length_m_ = 0.0;
  Eigen::Vector2d end_place_;  ///< end of the last leg
  double end_yaw_rad_, end_s_;
};

/// Checks the route every 2 cm and 2 degrees. Throws std::runtime_error that names the place and
/// the obstacle if the PR2's body collides with the world. Throws it, too, if a route with heights
/// leaves the ground by more than 5 cm.
void require_free(const World& world, const Route& route);

}  // namespace ribbon_mapper::sim
