// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/pr2.hpp"

namespace ribbon_mapper::sim::pr2 {

Pose T_base_laser(double tilt_rad, double torso_m) {
  // base_footprint_joint, torso_lift_joint, laser_tilt_mount_joint (about +y), laser_tilt_joint
  const Eigen::Vector3d axis(-0.05 + 0.09893, 0.0, 0.051 + 0.739675 + torso_m + 0.227);
  const Eigen::Vector3d lever(0.0, 0.0, 0.03);
  Pose result = Pose::Identity();
  result.linear() = Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  result.translation() = axis + result.linear() * lever;
  return result;
}

Pose T_map_body(const Pose& T_map_base) {
  return T_map_base * Eigen::Translation3d(0.0, 0.0, kBodyBottom_m + kBodySize_m.z() / 2.0);
}

}  // namespace ribbon_mapper::sim::pr2
