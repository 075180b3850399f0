// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sim/tour/tour.hpp"

namespace ribbon_mapper::sim {

/// Names of the frames in tf, as on the PR2.
struct SimulatorFrames {
  std::string map = "map";
  std::string odom = "odom_combined";
  std::string base = "base_footprint";
};

/// The private parameters of pr2_simulator.
struct SimulatorParameters {
  std::string world, route;
  std::vector<std::string> model_paths;
  TourConfig tour;
  SimulatorFrames frames;
  double rate;                        ///< seconds of tour per second
  std::vector<std::string> wait_for;  ///< topics that need a subscriber before the tour starts
  double longest_wait_s;

  /// Throws std::invalid_argument that names the parameter and what is allowed.
  static SimulatorParameters read();
};

}  // namespace ribbon_mapper::sim
