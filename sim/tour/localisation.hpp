// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/tour/odometry_faults.hpp"
#include "sim/tour/route.hpp"

namespace ribbon_mapper::sim {

/// Noise of the simulated localisation. The defaults are gmapping's as configured for the PR2
/// (pr2_navigation_slam/slam_gmapping.xml).
struct LocalisationConfig {
  double drift = 1.0;  ///< multiplies every sigma below; 0: exact poses on level ground

  // gmapping's motion model: sigma per reference step, which is one update of the filter.
  double srr = 0.01;                  ///< translation from translation [m/m]
  double srt = 0.02;                  ///< rotation from translation [rad/m]
  double str = 0.01;                  ///< translation from rotation [m/rad]
  double stt = 0.02;                  ///< rotation from rotation [rad/rad]
  double linear_update_m = 0.5;       ///< reference step of a drive
  double angular_update_rad = 0.436;  ///< reference step of a turn

  // Scan matching: the optimiser stops at lstep and astep (0.05 m, 0.05 rad) halved five times.
  // Within a cell of the grid (delta 0.05 m) the position is unobservable: delta / sqrt(12). For
  // the heading, that is seen at the end of the beams (maxUrange 16 m).
  double jitter_m = 0.05 / 32.0;                         ///< of each match, white
  double jitter_rad = 0.05 / 32.0;                       ///< of each match, white
  double wander_m = 0.05 / 3.4641016151377544;           ///< correlated over one update
  double wander_rad = 0.05 / 3.4641016151377544 / 16.0;  ///< correlated over one update

  double odometry_rate_hz = 100.0;  ///< pr2_odometry.yaml
  double map_rate_hz = 30.0;        ///< the paper: 25 to 30 Hz

  OdometryFaults faults;  ///< slips, pushes and wrong scales; none

  /// Throws std::invalid_argument that names a wrong key and its range.
  void validate() const;
};

/// The poses that odometry and SLAM estimate along a route, without loop closure. On ramps they
/// have the true pitch, as an IMU gives it, but stay at height 0 (robot_pose_ekf).
class Localisation {
 public:
  /// Simulates the whole route. Throws std::invalid_argument if the configuration is not valid.
  Localisation(const Route& route, const LocalisationConfig& config, std::uint64_t seed);

  /// Returns the pose by odometry; its frame starts at the robot's first pose.
  Pose T_odom_base(Time time) const;
  /// Returns the correction by SLAM, interpolated as tf does.
  Pose T_map_odom(Time time) const;

 private:
  void drive_odometry(std::mt19937_64& random);
  void match_scans(std::mt19937_64& random);

  Route route_;
  LocalisationConfig config_;
  std::vector<Pose> T_odom_map_;  ///< drift at the odometry's rate: T_odom_base * T_base_map
  std::vector<Pose> T_map_odom_;  ///< at the map's rate
};

}  // namespace ribbon_mapper::sim
