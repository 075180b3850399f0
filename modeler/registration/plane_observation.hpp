// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/registration/pose_belief.hpp"
#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// Part of a range's sigma that the points of a ribbon share (bias of a surface, of an angle).
/// Poses that are known better than that have nothing to learn from ribbons.
constexpr double shared_part_of_sigma = 0.25;

/// A plane that ribbons are registered against. Its error: rotations that tip its normal towards
/// axis u and axis v [rad], and the offset at its centroid along the normal [m].
struct SightedPlane {
  Eigen::Vector3d normal, axis_u, axis_v, centroid;
};

/// What a ribbon measures of a plane: the distance of its centroid and the tilt of its direction.
/// (How it lies across its direction hangs on the odometry from line to line, and is only used to
/// tell planes apart.) In the frame of its acquisition pose.
struct Sight {
  /// `motion_variances`: of the base's motion between the middle of the line and a beam.
  Sight(const Ribbon& ribbon, double range_sigma_m, const Vector6& motion_variances);

  Eigen::Vector3d centroid, normal, along, across;
  double sigma_across_rad;
  Eigen::Vector2d variances;          ///< of distance [m2] and tilt [rad2], of ranges and motion
  std::vector<std::uint32_t> planes;  ///< that it may lie on
};

/// Distance [m] and tilt [rad] of a ribbon from a plane.
Eigen::Vector2d residual_of(const Sight& sight, const SightedPlane& plane,
                            const Pose& T_model_base);

/// Derivatives of the residual by the error of the pose (see PoseBelief) and of the plane.
Eigen::Matrix<double, 2, 6> by_pose(const Sight& sight, const Eigen::Vector3d& normal,
                                    const Pose& T_model_base);
Eigen::Matrix<double, 2, 3> by_plane(const Sight& sight, const SightedPlane& plane,
                                     const Pose& T_model_base);

/// The plane moved by an error.
SightedPlane moved(const SightedPlane& plane, const Eigen::Vector3d& error);

/// Weight of a residual that is so many sigmas out, squared (Cauchy): half at two sigma.
inline double robust_weight(double square_sigmas) { return 1.0 / (1.0 + square_sigmas / 4.0); }

}  // namespace ribbon_mapper
