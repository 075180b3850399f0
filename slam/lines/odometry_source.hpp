// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::slam {

/// Where the motion from line to line comes from, if not from the recorded odometry.
class OdometrySource {
 public:
  virtual ~OdometrySource() = default;

  /// Returns the base at a line's stamp. `recorded` is the pose in odom that the odometry gave. As
  /// in odom, only the motion between two poses counts. Is asked once for each line, in their
  /// order.
  virtual Pose T_odom_base(Time stamp, const Pose& recorded) const = 0;

  /// Returns the covariance of a motion's error in the plane by what this source has measured alone
  /// [m2, m rad, rad2], along the axes of the base before it. `step` is the motion from one line to
  /// another as of T_odom_base(). 1 m2 or 1 rad2 stand for what was not measured: there, the motion
  /// is as uncertain as the recorded one.
  virtual Eigen::Matrix3d step_covariance(Time from, Time to, const Pose& step) const = 0;

 protected:
  OdometrySource() = default;
  OdometrySource(const OdometrySource&) = default;
  OdometrySource& operator=(const OdometrySource&) = default;
};

}  // namespace ribbon_mapper::slam
