// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/geometry/square.hpp"
#include "modeler/registration/pose_belief.hpp"
#include "modeler/ribbon/ribbon.hpp"

namespace ribbon_mapper {

/// The noise of ranges.
struct RangeNoise {
  double sigma_m;       ///< standard deviation of one range [m]
  double shared_ratio;  ///< part of it that all points of a ribbon share, see RegistrationConfig

  /// Returns the standard deviation that no number of points reduces [m].
  double shared_sigma_m() const { return shared_ratio * sigma_m; }
};

/// A plane that ribbons are registered to, in the model frame. Its error has three components:
/// rotations that tip the normal towards axis u and axis v [rad], and the offset of the centroid
/// along the normal [m].
struct PlaneLandmark {
  Eigen::Vector3d normal;    ///< unit, towards the side that was seen
  Eigen::Vector3d axis_u;    ///< unit, in the plane
  Eigen::Vector3d axis_v;    ///< normal x axis_u
  Eigen::Vector3d centroid;  ///< of the points that were seen [m]
};

/// What a ribbon measures of a plane, in the frame of its acquisition pose: the distance of its
/// centroid and the tilt of its direction. Its tilt across that direction depends on the odometry
/// from line to line and only serves to reject other planes.
struct PlaneObservation {
  /// `step_variances`: of the base's motion from line to line, along the axes of the base
  /// [m2, rad2].
  PlaneObservation(const Ribbon& ribbon, const RangeNoise& noise, const Vector6& step_variances);

  Eigen::Vector3d centroid;               ///< of the ribbon's points [m]
  Eigen::Vector3d normal;                 ///< unit, towards the sensor
  Eigen::Vector3d along;                  ///< unit direction of the ribbon
  Eigen::Vector3d across;                 ///< normal x along
  double sigma_across_rad;                ///< standard deviation of the tilt across the ribbon
  Eigen::Vector2d variances;              ///< of distance [m2] and tilt [rad2]: ranges and motion
  std::vector<std::uint32_t> candidates;  ///< landmarks near it, see PlaneLandmarks::find_near()
};

/// Returns the distance [m] and the tilt [rad] of a ribbon from a plane.
Eigen::Vector2d residual_of(const PlaneObservation& observation, const PlaneLandmark& landmark,
                            const Pose& T_model_base);

/// Returns the derivative of residual_of() by the error of the pose (see PoseBelief), at a plane
/// of this normal.
Eigen::Matrix<double, 2, 6> derivative_by_pose(const PlaneObservation& observation,
                                               const Eigen::Vector3d& normal,
                                               const Pose& T_model_base);

/// Returns the derivative of residual_of() by the error of the landmark.
Eigen::Matrix<double, 2, 3> derivative_by_landmark(const PlaneObservation& observation,
                                                   const PlaneLandmark& landmark,
                                                   const Pose& T_model_base);

/// Returns the landmark moved by an error: tips towards u and v [rad], and offset [m].
PlaneLandmark moved(const PlaneLandmark& landmark, const Eigen::Vector3d& error);

/// Returns Cauchy's weight of a residual from its squared Mahalanobis distance: one half at
/// `half_weight_sigmas`.
inline double robust_weight(double square_sigmas, double half_weight_sigmas) {
  return 1.0 / (1.0 + square_sigmas / square(half_weight_sigmas));
}

}  // namespace ribbon_mapper
