// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/pose.hpp"

#include <cmath>

#include "modeler/geometry/pose_defect.hpp"

namespace ribbon_mapper {

Pose interpolate(const Pose& from, const Pose& to, double fraction) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(from.linear()).slerp(fraction, Eigen::Quaterniond(to.linear()));
  Pose pose = Pose::Identity();
  pose.linear() = rotation.toRotationMatrix();
  pose.translation() = (1.0 - fraction) * from.translation() + fraction * to.translation();
  return pose;
}

Pose planar_pose(double x_m, double y_m, double yaw_rad) {
  return Eigen::Translation3d(x_m, y_m, 0.0) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

double yaw_of(const Pose& pose) { return std::atan2(pose(1, 0), pose(0, 0)); }

double angle_of(const Pose& pose) { return Eigen::AngleAxisd(pose.linear()).angle(); }

bool is_valid(const Pose& pose) { return !find_defect(pose); }

}  // namespace ribbon_mapper
