// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/pr2.hpp"

#include <cmath>

namespace ribbon_mapper::sim::pr2 {

Pose T_base_laser(double tilt_rad, double torso_m) {
  // base_footprint_joint, torso_lift_joint, laser_tilt_mount_joint (about +y), laser_tilt_joint
  const Eigen::Vector3d axis(-0.05 + 0.09893, 0.0, 0.051 + 0.739675 + torso_m + 0.227);
  const double lever_m = 0.03, c = std::cos(tilt_rad), s = std::sin(tilt_rad);
  Pose result = Pose::Identity();
  result.linear() << c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c;
  result.translation() = axis + lever_m * result.linear().col(2);
  return result;
}

Pose T_map_body(const Pose& T_map_base) {
  return T_map_base * Eigen::Translation3d(0.0, 0.0, kBodyBottom_m + kBodySize_m.z() / 2.0);
}

}  // namespace ribbon_mapper::sim::pr2
