// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/robot/tilt_profile.hpp"
#include "sim/tour/localisation.hpp"
#include "sim/tour/route.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {

/// Everything that a simulated tour depends on. The same configuration gives the same bytes.
struct TourConfig {
  HokuyoConfig hokuyo;
  TiltProfileConfig tilt;
  LocalisationConfig localisation;
  std::uint64_t seed = 1;
};

/// A PR2 that drives a route through a world and scans with its tilting laser: from time 0 on, as
/// many lines as end before the route does. The world must outlive the tour.
class Tour {
 public:
  /// Throws std::invalid_argument (a bad value) or std::runtime_error (a route that collides).
  Tour(const World& world, const Route& route, const TourConfig& config);
  ~Tour();
  Tour(const Tour&) = delete;
  Tour& operator=(const Tour&) = delete;

  Time duration() const;
  std::size_t line_count() const;  ///< lines of the whole tour

  /// The next line of the laser, nothing after the last.
  std::optional<Scan> next_scan();

  /// Any line of the tour, the same as next_scan() gives. Thread-safe.
  Scan scan(std::size_t line) const;

  // Poses at any time of the tour, 0 .. duration().
  Pose true_T_map_base(Time time) const;
  Velocity true_velocity(Time time) const;  ///< of the base, in its own frame
  Pose T_odom_base(Time time) const;        ///< odometry with its drift
  Pose T_map_odom(Time time) const;         ///< what the simulated SLAM says
  Pose noisy_T_map_base(Time time) const;   ///< T_map_odom * T_odom_base
  double tilt_angle(Time time) const;       ///< laser_tilt_mount_joint [rad], positive looks down
  Pose T_base_laser(Time time) const;       ///< laser_tilt_link in base_footprint

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
