// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "modeler/geometry/pose.hpp"

/// Geometry and limits of the PR2, from pr2_description (pr2.urdf.xacro and its includes) and
/// pr2_controller_configuration (pr2_base_controller2.yaml).
namespace ribbon_mapper::sim::pr2 {

constexpr double kTiltLower_rad = -0.7854;  ///< laser_tilt_mount_joint, looks up
constexpr double kTiltUpper_rad = 1.48353;  ///< looks down
constexpr double kTiltSpeed_rad_s = 10.0;   ///< limit of the joint
constexpr double kTorsoRest_m = 0.0115;     ///< torso_lift_joint at its lower soft stop

constexpr double kCasters_m = 0.2246;  ///< from the base's centre to its casters, along x and y

constexpr double kBaseSpeed_m_s = 1.0;                ///< limit of a drive
constexpr double kBaseTurnRate_rad_s = 2.0;           ///< limit of a turn
constexpr double kBaseAcceleration_m_s2 = 2.0;        ///< limit of a drive
constexpr double kBaseTurnAcceleration_rad_s2 = 2.0;  ///< limit of a turn

/// Size of a box around the body, up to the head with the torso down.
inline const Eigen::Vector3d kBodySize_m{0.65, 0.65, 1.30};
constexpr double kBodyBottom_m = 0.05;  ///< height of that box above the floor

/// Returns the pose of laser_tilt_link in base_footprint: x ahead, z up at tilt 0.
Pose T_base_laser(double tilt_rad, double torso_m = kTorsoRest_m);

/// Returns T_map_base * T_base_laser; for a base on level ground, multiplied out.
Pose T_map_laser(const Pose& T_map_base, double tilt_rad);

/// Returns the pose of base_laser_link in base_footprint: level, x ahead, 0.303 m high.
Pose T_base_base_laser();

/// Returns the pose of the centre of the body's box.
Pose T_map_body(const Pose& T_map_base);

}  // namespace ribbon_mapper::sim::pr2
