// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/registration/pose_belief.hpp"

namespace ribbon_mapper {

/// Motion model of an odometry: a random walk. Its shape is that of gmapping (motionmodel.cpp) as
/// the PR2 runs it (pr2_navigation_slam/slam_gmapping.xml): sigma per reference step, which is one
/// update of the filter; the variance is spread evenly over the way, so that the error does not
/// depend on how finely the way is cut. What of it goes out of the plane is taken to be as what is
/// in it: z as y, roll and pitch as yaw. How large both are, the odometry shows: see fitted_to().
struct OdometryNoise {
  double srr = 0.01;                  ///< translation from translation [m/m]
  double srt = 0.02;                  ///< rotation from translation [rad/m]
  double str = 0.01;                  ///< translation from rotation [m/rad]
  double stt = 0.02;                  ///< rotation from rotation [rad/rad]
  double linear_update_m = 0.5;       ///< reference step of a drive
  double angular_update_rad = 0.436;  ///< reference step of a turn

  double planar = 1.0;   ///< scale of the sigmas of x, y and yaw
  double spatial = 1.0;  ///< scale of those of z, roll and pitch

  /// Of a step's error, in the frame of the base that made it.
  Vector6 variances(const Pose& step) const;
};

/// Some way that odometry went, and where the robot went in truth.
struct OdometryCheck {
  std::vector<Pose> steps;
  Pose T_first_last_true = Pose::Identity();
};

/// The noise with scales such that the errors that the odometry shows are what it expects. An
/// odometry without an error (or one that never leaves the plane) keeps a hundredth: that of a
/// floor level to 0.1 mrad. `checks` must not be empty.
OdometryNoise fitted_to(const std::vector<OdometryCheck>& checks);

}  // namespace ribbon_mapper
