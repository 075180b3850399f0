// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/scan/laser_beams.hpp"
#include "slam/matching/planar_pose.hpp"

namespace ribbon_mapper::slam {

/// Settings for making points of a level scan.
struct LevelScanConfig {
  double max_range_m = 30.0;  ///< farther returns are few and lie apart: they give no normal
  double spacing_m = 0.04;    ///< least distance of kept points: near walls would outvote far ones
  double normal_radius_m = 0.15;  ///< reach of a normal; longer than the noise of 1 to 3 cm
  double max_bend_m = 0.04;       ///< points scatter about a line by less; else no normal
  double max_tilt_rad = 0.1;      ///< a laser that is inclined more is not level
};

/// A return with the normal of its surface, which points to the side of the laser.
struct LevelPoint {
  float x_m = 0.0F;       ///< of the return
  float y_m = 0.0F;       ///< of the return
  float normal_x = 0.0F;  ///< both are 0 if the normal is unknown
  float normal_y = 0.0F;  ///< of unit length with normal_x
};

/// Points in the order of their beams.
using LevelPoints = std::vector<LevelPoint>;

/// The points of one rotation of a level laser.
struct LevelScan {
  Time stamp{0};       ///< of the first beam
  LevelPoints points;  ///< in base
};

/// Returns whether a laser at this pose scans a level plane, upside down or not.
bool is_level(const Pose& T_base_laser, const LevelScanConfig& config);

/// Returns the points of the beams in base. The robot moves from base at the first beam by
/// `T_first_last` until the last one. Beams without a return are left out.
LevelScan level_scan_of(const LaserBeams& beams, const Pose& T_base_laser,
                        const PlanarPose& T_first_last, const LevelScanConfig& config);

/// Returns a point that is given in source, in target.
inline LevelPoint moved(const LevelPoint& p, const PlanarPose& T_target_source, double c,
                        double s) {
  return {static_cast<float>(T_target_source.x_m + c * p.x_m - s * p.y_m),
          static_cast<float>(T_target_source.y_m + s * p.x_m + c * p.y_m),
          static_cast<float>(c * p.normal_x - s * p.normal_y),
          static_cast<float>(s * p.normal_x + c * p.normal_y)};
}

/// Appends points that are given in source, in target.
void append_moved(const LevelPoints& points, const PlanarPose& T_target_source,
                  LevelPoints& moved_points);

}  // namespace ribbon_mapper::slam
