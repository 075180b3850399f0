// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::slam {

/// The base at a line, by a better odometry than the recorded one.
struct RefinedPose {
  Pose T_odom_base = Pose::Identity();  ///< as in odom, only the motion between two poses counts
  /// False if the motion up to this line may be as wrong as the recorded one.
  bool is_refined = false;
};

/// Where the motion from line to line comes from, if not from the recorded odometry.
class OdometrySource {
 public:
  virtual ~OdometrySource() = default;

  /// Returns the base at a line's stamp. `recorded` is the pose in odom that the odometry gave. Is
  /// asked once for each line, in their order.
  virtual RefinedPose refined(Time stamp, const Pose& recorded) const = 0;

 protected:
  OdometrySource() = default;
  OdometrySource(const OdometrySource&) = default;
  OdometrySource& operator=(const OdometrySource&) = default;
};

}  // namespace ribbon_mapper::slam
