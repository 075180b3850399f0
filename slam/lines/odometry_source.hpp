// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::slam {

/// Where the motion from line to line comes from, if not from the recorded odometry.
class OdometrySource {
 public:
  virtual ~OdometrySource() = default;

  /// Returns the base in odom at a line's stamp. `recorded` is the pose that the odometry gave. As
  /// in odom, only the motion between two poses counts. Is asked once for each line, in their
  /// order.
  virtual Pose T_odom_base(Time stamp, const Pose& recorded) const = 0;

 protected:
  OdometrySource() = default;
  OdometrySource(const OdometrySource&) = default;
  OdometrySource& operator=(const OdometrySource&) = default;
};

}  // namespace ribbon_mapper::slam
