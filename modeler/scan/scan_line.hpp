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

/// One rotation of the laser with every beam placed where the robot and the tilt were when it was
/// fired. Points are in the odom frame, which is continuous: neighbouring lines fit each other even
/// when map jumps. Positions in odom are relative to `odom_origin`, so that sums of squares keep
/// their precision far from zero. Beams without a return keep their place, with range 0.
struct ScanLine {
  Time stamp{0};                        ///< half way between the first and the last beam
  Pose T_map_base = Pose::Identity();   ///< acquisition pose: base in map at `stamp`
  Pose T_odom_base = Pose::Identity();  ///< base in odom at `stamp`, relative to `odom_origin`
  Eigen::Vector3d odom_origin = Eigen::Vector3d::Zero();  ///< subtracted from positions in odom [m]
  double first_angle_rad = 0.0;                           ///< angle of the first beam
  double angle_increment_rad = 0.0;  ///< angle between neighbouring beams, signed
  double half_increment_sine = 0.0;  ///< sin(dtheta / 2) of eq. 2
  std::size_t averaged_lines = 1;    ///< number of lines that this one is the mean of
  Eigen::Vector3d first_origin = Eigen::Vector3d::Zero();  ///< origin of the first beam, odom [m]
  Eigen::Vector3d origin_step = Eigen::Vector3d::Zero();   ///< from one beam's origin to the next's
  std::vector<float> ranges_m;                             ///< range of each beam; 0: no return
  std::vector<Eigen::Vector3d> directions;                 ///< unit direction of each beam, odom
  std::vector<Eigen::Vector3d> points;  ///< odom [m]; meaningless where the range is 0
  /// For each beam, the first beam of its segment: beams without a jump in depth between them.
  std::vector<std::uint32_t> first_of_segment;
  std::vector<std::uint32_t> end_of_segment;  ///< one past the last beam of each beam's segment
  std::vector<Moments> before;  ///< before[i]: moments of the returns among beams 0 .. i-1
  LaserBeams beams;             ///< what the line was placed from
  LinePoses poses;              ///< where it was placed, relative to `odom_origin`

  /// Returns the number of beams.
  std::size_t size() const { return ranges_m.size(); }
  /// Returns true if the beam has a return.
  bool has_return(std::size_t beam) const { return ranges_m[beam] > 0.0F; }
  /// Returns true if any beam has a return.
  bool has_returns() const { return !before.empty() && before.back().weight() > 0.0; }
  /// Returns the origin of a beam in odom [m].
  Eigen::Vector3d origin(std::size_t beam) const {
    return first_origin + static_cast<double>(beam) * origin_step;
  }
  /// Returns the moments of the returns among beams [begin, end).
  Moments moments(std::size_t begin, std::size_t end) const { return before[end] - before[begin]; }
};

/// Returns true if the range is a return: finite, and within the limits of driver and preset.
bool is_return(float range_m, const LaserBeams& beams, const ScanConfig& config);

/// Returns true if a return is a mixed pixel: it hangs in mid-air between two depths. See
/// ScanConfig::mixed_pixel_angle_deg; `step_per_range` is mixed_pixel_step_per_range().
bool is_mixed_pixel(const LaserBeams& beams, std::size_t beam, const ScanConfig& config,
                    double step_per_range);

/// Returns the smallest step between neighbouring ranges, per metre of range, that marks a mixed
/// pixel. It is infinite if mixed pixels are kept.
double mixed_pixel_step_per_range(const LaserBeams& beams, const ScanConfig& config);

/// Returns what is wrong with the beams or the poses of a line, or nothing if they are usable.
std::optional<std::string> find_defect(const LaserBeams& beams, const LinePoses& poses);

/// Places the beams of a line. `beams` and `poses` must be free of defects; `line` is overwritten
/// and keeps its capacity and its `odom_origin`, which the poses must be relative to.
void place_beams(const LaserBeams& beams, const LinePoses& poses, const ScanConfig& config,
                 ScanLine& line);

}  // namespace ribbon_mapper
