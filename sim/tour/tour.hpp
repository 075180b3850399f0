// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/robot/tilt_profile.hpp"
#include "sim/tour/localisation.hpp"
#include "sim/tour/route.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {

/// Everything that a tour depends on, besides world and route. The same configuration gives the
/// same bytes.
struct TourConfig {
  HokuyoConfig hokuyo;                                    ///< tilting laser
  TiltProfileConfig tilt;                                 ///< motion of the tilting laser
  HokuyoConfig base_hokuyo = HokuyoConfig::base_laser();  ///< laser on the base
  LocalisationConfig localisation;                        ///< noise of odometry and SLAM
  std::uint64_t seed = 1;                                 ///< of all random numbers
};

/// A PR2 that drives a route through a world and scans with its tilting laser and with the laser on
/// its base. Lines of both start at time 0; the last ones end before the route does. The lines of
/// one laser do not depend on the other's: each has its own random numbers. A line that nobody asks
/// for costs nothing.
class Tour {
 public:
  /// Prepares the tour; the world must outlive it. Throws std::invalid_argument (a bad value) or
  /// std::runtime_error (a route that collides, or from which nothing is seen).
  Tour(const World& world, const Route& route, const TourConfig& config);
  ~Tour();
  Tour(const Tour&) = delete;
  Tour& operator=(const Tour&) = delete;

  /// Returns in one line what the laser sees along the route, for the user.
  const std::string& view() const;
  /// Returns the duration of the route.
  Time duration() const;
  /// Returns the number of lines of the tilting laser in the whole tour.
  std::size_t line_count() const;
  /// Returns the number of lines of the base laser in the whole tour.
  std::size_t base_line_count() const;

  /// Returns the next line of the tilting laser, nothing after the last.
  std::optional<Scan> next_scan();

  /// Returns any line of the tour, the same as next_scan() returns. For several threads at once.
  Scan scan(std::size_t line) const;

  /// Returns any line of the base laser, counted from 0. For several threads at once.
  Scan base_scan(std::size_t line) const;
  /// Returns the time of the first beam of a line of the base laser.
  Time base_scan_stamp(std::size_t line) const;
  /// Returns the time of the last beam of a line of the base laser.
  Time base_scan_end(std::size_t line) const;

  // Times from 0 to duration().
  /// Returns the true pose of the base.
  Pose true_T_map_base(Time time) const;
  /// Returns the true velocity of the base, in its own frame.
  Velocity true_velocity(Time time) const;
  /// Returns the pose by odometry, with its drift.
  Pose T_odom_base(Time time) const;
  /// Returns the true pose of odom in map at the start. The drift moves it later.
  Pose T_map_odom_at_start() const;
  /// Returns the correction by the simulated SLAM.
  Pose T_map_odom(Time time) const;
  /// Returns the pose by odometry and SLAM: T_map_odom * T_odom_base.
  Pose noisy_T_map_base(Time time) const;
  /// Returns laser_tilt_mount_joint [rad]; positive looks down.
  double tilt_angle(Time time) const;
  /// Returns the pose of laser_tilt_link in base_footprint.
  Pose T_base_laser(Time time) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
