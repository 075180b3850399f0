// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/moments.hpp"
#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper {

/// One rotation of the laser with every beam placed where the robot and the tilt were at that
/// beam's own time, in the odom frame (continuous, so neighbouring lines fit each other even when
/// map jumps). Beams without a return keep their place with range 0.
struct ScanLine {
  Time stamp{0};                        ///< half way between the first and the last beam
  Pose T_map_base = Pose::Identity();   ///< acquisition pose
  Pose T_odom_base = Pose::Identity();  ///< at the same time
  double angle_increment_rad = 0.0;
  double half_increment_sine = 0.0;                        ///< sin(dtheta / 2) of eq. 2
  std::size_t averaged_lines = 1;                          ///< that this one is the mean of
  Eigen::Vector3d first_origin = Eigen::Vector3d::Zero();  ///< of the first beam, odom
  Eigen::Vector3d origin_step = Eigen::Vector3d::Zero();   ///< from each beam's to the next one's
  std::vector<float> ranges_m;                             ///< 0: no return
  std::vector<Eigen::Vector3d> directions;                 ///< of each beam, odom, unit length
  std::vector<Eigen::Vector3d> points;  ///< odom; meaningless where the range is 0
  /// Beams [first_of_segment[i], end_of_segment[i]) have returns without a jump in depth.
  std::vector<std::uint32_t> first_of_segment, end_of_segment;
  std::vector<Moments> before;  ///< before[i]: moments of the returns among beams 0 .. i-1

  std::size_t size() const { return ranges_m.size(); }
  bool has_return(std::size_t beam) const { return ranges_m[beam] > 0.0F; }
  Eigen::Vector3d origin(std::size_t beam) const {
    return first_origin + static_cast<double>(beam) * origin_step;
  }
  /// Moments of the returns among beams [begin, end).
  Moments moments(std::size_t begin, std::size_t end) const { return before[end] - before[begin]; }
};

/// True if a range is one: finite, within what the driver says, within what the preset allows.
bool is_return(float range_m, const LaserBeams& beams, const ScanConfig& config);

/// True if a return hangs in mid-air between two depths, see ScanConfig::mixed_pixel_angle_deg.
bool is_mixed_pixel(const LaserBeams& beams, std::size_t beam, const ScanConfig& config,
                    double step_per_range);

/// Of beams that meet a surface under the veil angle, the step in range per metre of range: an
/// angle below it makes a larger one. Infinite if veils are kept.
double mixed_pixel_step_per_range(const LaserBeams& beams, const ScanConfig& config);

/// What is wrong with the beams or the poses of a line; nothing if they are usable.
std::optional<std::string> defect_of(const LaserBeams& beams, const LinePoses& poses);

/// Places the beams. `beams` and `poses` must be free of defects. `line` is overwritten and keeps
/// its capacity.
void place_beams(const LaserBeams& beams, const LinePoses& poses, const ScanConfig& config,
                 ScanLine& line);

}  // namespace ribbon_mapper
