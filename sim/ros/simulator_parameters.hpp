// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sim/tour/tour.hpp"

namespace ribbon_mapper::sim {

/// Names of the frames in tf, by default those of the PR2.
struct SimulatorFrames {
  std::string map = "map";              ///< of the world
  std::string odom = "odom_combined";   ///< of the odometry
  std::string base = "base_footprint";  ///< of the robot
};

/// The private parameters of pr2_simulator.
struct SimulatorParameters {
  std::string world;                     ///< SDF file
  std::string route;                     ///< YAML file
  std::vector<std::string> model_paths;  ///< folders for `model://` URIs
  bool visuals;                          ///< takes models without collision from their visuals
  RayCasterKind caster;                  ///< library that casts the rays
  TourConfig tour;                       ///< sensors, noise and seed
  SimulatorFrames frames;                ///< names of the frames
  bool localisation;                     ///< see TourPublisher
  double rate;                           ///< seconds of tour per second
  std::vector<std::string> wait_for;     ///< topics that need a subscriber before the tour starts
  double longest_wait_s;                 ///< for these subscribers; then the tour starts anyway

  /// Reads the parameters of this node. Throws std::invalid_argument that names a wrong parameter
  /// and what is allowed.
  static SimulatorParameters read();
};

}  // namespace ribbon_mapper::sim
