// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper {

/// A rigid transform [m]. A variable `T_target_source` transforms points from `source` to `target`.
using Pose = Eigen::Isometry3d;

/// A pose of the robot with its time.
struct StampedPose {
  Time stamp{0};                       ///< time of the pose
  Pose T_map_base = Pose::Identity();  ///< pose of base_footprint in map
};

/// Returns the pose at `fraction` of the way (0 at `from`, 1 at `to`): the rotation along a great
/// circle, the translation along a straight line.
Pose interpolate(const Pose& from, const Pose& to, double fraction);

/// Returns a pose in the plane z = 0 with this heading about +z.
Pose planar_pose(double x_m, double y_m, double yaw_rad);

/// Returns the heading of the x-axis about +z [rad], in -pi..pi.
double yaw_of(const Pose& pose);

/// Returns the rotation angle of `pose` [rad], in 0..pi.
double angle_of(const Pose& pose);

/// Returns true if a pose is finite, rigid to 1e-6 and no mirror, and within 1e9 m of the origin.
bool is_valid(const Pose& pose);

}  // namespace ribbon_mapper
