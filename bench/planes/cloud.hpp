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

/// Selects the acquisition poses.
enum class Poses {
  noisy,  ///< with the errors of the localisation
  truth   ///< without errors
};

/// All returns of a tour in one cloud, in map.
struct TourCloud {
  std::vector<Eigen::Vector3f> points;   ///< the returns
  std::vector<Eigen::Vector3f> sensors;  ///< position of the sensor for each return
};

/// Accumulates all returns of a tour.
TourCloud cloud_of(const Recording& tour, const ScanConfig& config, Poses poses);

/// The lines of a half-period of the tilt as an image with one row per line. Its frame is that of
/// the laser at the middle line, rotated so that z points ahead.
struct Sweep {
  std::size_t width = 0;                ///< number of beams
  std::vector<Eigen::Vector3f> pixels;  ///< points by row, NaN where there is no return
  Pose T_map_image = Pose::Identity();  ///< pose of the image in map
};

/// Divides a tour into sweeps.
std::vector<Sweep> sweeps_of(const Recording& tour, const ScanConfig& config, Poses poses,
                             std::size_t lines_per_sweep);

/// Directions from which places were observed. Clouds without normals do not hold them, but planes
/// must have a side to be compared with the truth.
class ViewField {
 public:
  /// Averages the directions to the sensor in each voxel.
  explicit ViewField(const TourCloud& cloud);

  /// Returns the sum of unit vectors to the sensor near `point`, zero if there are none.
  Eigen::Vector3f towards_sensor(const Eigen::Vector3f& point) const;

 private:
  static std::uint64_t key_of(const Eigen::Vector3f& point);
  std::unordered_map<std::uint64_t, Eigen::Vector3f> sums_;
};

}  // namespace ribbon_mapper::bench
