// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/robot/pr2.hpp"

#include <cmath>

namespace ribbon_mapper::sim::pr2 {

namespace {

// base_footprint_joint, torso_lift_joint, laser_tilt_mount_joint (about +y), laser_tilt_joint
constexpr double kAxisX_m = -0.05 + 0.09893, kAxisZ_m = 0.051 + 0.739675 + 0.227;
constexpr double kLever_m = 0.03;

}  // namespace

Pose T_base_laser(double tilt_rad, double torso_m) {
  const double c = std::cos(tilt_rad), s = std::sin(tilt_rad);
  Pose result = Pose::Identity();
  result.linear() << c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c;
  result.translation() << kAxisX_m + kLever_m * s, 0.0, kAxisZ_m + torso_m + kLever_m * c;
  return result;
}

Pose T_map_laser(const Pose& T_map_base, double tilt_rad) {
  if (T_map_base(2, 2) < 1.0 - 1e-12) return T_map_base * T_base_laser(tilt_rad);
  const double c = std::cos(tilt_rad), s = std::sin(tilt_rad);
  const double ahead_x = T_map_base(0, 0), ahead_y = T_map_base(1, 0);
  const double x_m = kAxisX_m + kLever_m * s, z_m = kAxisZ_m + kTorsoRest_m + kLever_m * c;
  Pose result;
  result.matrix() << ahead_x * c, -ahead_y, ahead_x * s, T_map_base(0, 3) + ahead_x * x_m,  //
      ahead_y * c, ahead_x, ahead_y * s, T_map_base(1, 3) + ahead_y * x_m,                  //
      -s, 0.0, c, T_map_base(2, 3) + z_m,                                                   //
      0.0, 0.0, 0.0, 1.0;
  return result;
}

// base_footprint_joint, base_laser_joint
Pose T_base_base_laser() { return Pose(Eigen::Translation3d(0.275, 0.0, 0.051 + 0.252)); }

Pose T_map_body(const Pose& T_map_base) {
  return T_map_base * Eigen::Translation3d(0.0, 0.0, kBodyBottom_m + kBodySize_m.z() / 2.0);
}

}  // namespace ribbon_mapper::sim::pr2
