// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/trajectory/tracked_poses.hpp"

namespace ribbon_mapper {

/// Change of a trajectory: what takes a pose as it was recorded to where a corrected trajectory
/// says it was. At a corrected pose's time it is exactly that pose. Between two of them the robot
/// went as its odometry says, and where odom lies in the corrected map is interpolated: a live
/// localisation jumps about in between, odometry does not. Before the first and after the last, the
/// nearest change of the recorded poses in map holds. What odometry does not know in between, the
/// planes do: see registered_poses().
class Correction {
 public:
  /// Poses of `corrected` that lie outside of the time of `recorded` (in order, not empty) are left
  /// out. Throws std::invalid_argument saying what is wrong if `corrected` is empty, not strictly
  /// in order, not finite, or if none of its poses lies within the time of `recorded`.
  Correction(const TrackedPoses& recorded, const std::vector<StampedPose>& corrected);

  Pose corrected(const TrackedPose& recorded) const;

  /// The corrected poses that lie within the time of the recorded ones, with the odometry then.
  const TrackedPoses& poses() const { return poses_; }

 private:
  Pose T_corrected_odom(std::size_t index) const;

  TrackedPoses poses_;
  Pose first_change_, last_change_;  // take recorded poses in map to corrected ones
};

}  // namespace ribbon_mapper
