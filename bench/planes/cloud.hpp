// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bench/recording/recording.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper::bench {

enum class Poses { believed, true_ones };

/// All returns of a tour in one cloud in map, as a user would accumulate them.
struct TourCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> sensors;  ///< where each was seen from
};
TourCloud cloud_of(const Recording& tour, const ScanConfig& config, Poses poses);

/// Some successive lines as an image: row by row in the frame of the laser half way through, turned
/// so that z looks ahead; NaN where there is no return.
struct Sweep {
  std::size_t width = 0;
  std::vector<Eigen::Vector3f> pixels;
  Pose T_map_image = Pose::Identity();
};
std::vector<Sweep> sweeps_of(const Recording& tour, const ScanConfig& config, Poses poses,
                             std::size_t lines_per_sweep);

/// From which side places were seen: clouds without normals do not say, but the truth asks.
class ViewField {
 public:
  explicit ViewField(const TourCloud& cloud);
  /// Mean direction to the sensor of what lies near `point`, not of unit length.
  Eigen::Vector3f towards_sensor(const Eigen::Vector3f& point) const;

 private:
  static std::uint64_t key_of(const Eigen::Vector3f& point);
  std::unordered_map<std::uint64_t, Eigen::Vector3f> sums_;
};

}  // namespace ribbon_mapper::bench
