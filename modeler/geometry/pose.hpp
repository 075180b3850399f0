// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper {

/// Rigid transform. A variable is named `T_target_source`: it takes points of `source` to `target`.
using Pose = Eigen::Isometry3d;

struct StampedPose {
  Time stamp{0};
  Pose T_map_base = Pose::Identity();
};

/// Pose at `fraction` (0 at `from`, 1 at `to`): great-circle rotation, straight translation.
Pose interpolate(const Pose& from, const Pose& to, double fraction);

/// Pose in the plane: metres, and radians about +z.
Pose planar_pose(double x_m, double y_m, double yaw_rad);

/// Heading of the x-axis about +z [rad].
double yaw_of(const Pose& pose);

/// Rotation angle of `pose` [rad], in 0..pi.
double angle_of(const Pose& pose);

/// True if every element is finite and the rotation is orthonormal to 1e-6 and no mirror.
bool is_valid(const Pose& pose);

}  // namespace ribbon_mapper
