// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::slam {

/// Returns an angle [rad] in -pi..pi.
inline double wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * M_PI); }

/// A rigid transform in the plane. `T_target_source` transforms points from `source` to `target`.
struct PlanarPose {
  double x_m = 0.0;      ///< of the source's origin, in target
  double y_m = 0.0;      ///< of the source's origin, in target
  double yaw_rad = 0.0;  ///< of the source's x-axis, in target; -pi..pi

  /// Returns x, y [m] and yaw [rad].
  Eigen::Vector3d vector() const { return {x_m, y_m, yaw_rad}; }
  /// Returns the translation [m].
  Eigen::Vector2d translation() const { return {x_m, y_m}; }
};

/// Returns the transform `T_a_b * T_b_c`.
inline PlanarPose operator*(const PlanarPose& T_a_b, const PlanarPose& T_b_c) {
  const double c = std::cos(T_a_b.yaw_rad), s = std::sin(T_a_b.yaw_rad);
  return {T_a_b.x_m + c * T_b_c.x_m - s * T_b_c.y_m, T_a_b.y_m + s * T_b_c.x_m + c * T_b_c.y_m,
          wrapped(T_a_b.yaw_rad + T_b_c.yaw_rad)};
}

/// Returns the inverse transform.
inline PlanarPose inverse(const PlanarPose& pose) {
  const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad);
  return {-c * pose.x_m - s * pose.y_m, s * pose.x_m - c * pose.y_m, -pose.yaw_rad};
}

/// Returns the pose `to` as seen from `from`.
inline PlanarPose relative(const PlanarPose& from, const PlanarPose& to) {
  return inverse(from) * to;
}

/// Returns the distance between the origins of two poses [m].
inline double distance_m(const PlanarPose& a, const PlanarPose& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

/// Returns what a pose is in the plane.
inline PlanarPose planar(const Pose& pose) {
  return {pose.translation().x(), pose.translation().y(), yaw_of(pose)};
}

/// Returns a pose, given as x, y [m] and yaw [rad].
inline PlanarPose planar(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), wrapped(vector.z())};
}

}  // namespace ribbon_mapper::slam
