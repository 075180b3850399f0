// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper::sim {

/// One rotation of the simulated laser: what sensor_msgs/LaserScan says, and what only the
/// simulator knows.
struct Scan {
  Time stamp{0};  ///< of the first beam
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double time_increment_s = 0.0;
  double scan_time_s = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m;  ///< +inf: no return (REP 117)
  std::vector<int> faces;       ///< index into World::faces() that the beam hit, -1 for none
  std::vector<float> true_ranges_m;  ///< without noise, +inf: no return
};

/// Sigma of a range, by name of its source.
enum class RangeNoise { none, gazebo, datasheet, pomerleau };

struct HokuyoConfig {
  double rate_hz = 40.0;
  double angle_min_rad = -0.829;
  double angle_max_rad = 0.829;
  double angle_increment_rad = 2.0 * 3.14159265358979323846 / 1440.0;
  double range_min_m = 0.1;
  double range_max_m = 30.0;
  RangeNoise noise = RangeNoise::datasheet;
  double noise_scale = 1.0;      ///< multiplies sigma
  bool mixed_pixels = true;      ///< ranges between two depths where the beam's spot meets both
  double quantisation_m = 0.001;
  void validate() const;         ///< throws std::invalid_argument naming the key and its range
};

}  // namespace ribbon_mapper::sim
