// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/registration/pose_belief.hpp"
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {

/// Motion model of an odometry whose error is a random walk.
///
/// Its shape is that of gmapping's motion model (motionmodel.cpp) with the parameters that the PR2
/// runs it with (pr2_navigation_slam, slam_gmapping.xml). Its scale is not assumed: fitted_noise()
/// estimates it from the odometry itself and corrected poses. Nothing is taken from the simulator.
///
/// gmapping states a standard deviation for one update of its filter, the reference step. Here the
/// variance is spread evenly over the way, so it does not depend on how finely the way is divided.
/// gmapping's model is planar: z is taken to err as y, roll and pitch as yaw, with their own scale.
struct OdometryNoise {
  double srr = 0.01;                  ///< translation from translation [m/m]
  double srt = 0.02;                  ///< rotation from translation [rad/m]
  double str = 0.01;                  ///< translation from rotation [m/rad]
  double stt = 0.02;                  ///< rotation from rotation [rad/rad]
  double linear_update_m = 0.5;       ///< reference step of a translation [m]
  double angular_update_rad = 0.436;  ///< reference step of a rotation [rad]

  double planar_scale = 1.0;   ///< factor of the standard deviations of x, y and yaw
  double spatial_scale = 1.0;  ///< factor of the standard deviations of z, roll and pitch

  /// Returns the variances of a step's error, along the axes of the base before the step
  /// [m2, rad2]. They are positive even if the base stands still.
  Vector6 variances(const Pose& step) const;
};

/// Returns the noise whose scales match the mismatch that the odometry shows over segments of two
/// known ends; open segments are ignored. A scale is at least 0.01, also if there is no mismatch.
/// Throws std::invalid_argument if all segments are open.
OdometryNoise fitted_noise(const std::vector<TrajectorySegment>& segments);

/// Sets the variances of a segment's steps.
void set_step_variances(const OdometryNoise& noise, TrajectorySegment& segment);

}  // namespace ribbon_mapper
