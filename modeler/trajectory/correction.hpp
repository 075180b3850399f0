// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/trajectory/tracked_poses.hpp"

namespace ribbon_mapper {

/// The change that takes a pose as it was recorded to where a corrected trajectory says it was.
///
/// At the stamp of a corrected pose the result is exactly that pose. Between two corrected poses
/// the robot moved as its odometry says, and the pose of odom in the corrected map is interpolated:
/// a live localisation jumps between corrections, odometry does not. Before the first and after the
/// last corrected pose, the nearest change of the recorded poses in map applies. What odometry does
/// not know between corrected poses can be recovered from planes: see registered_poses().
class Correction {
 public:
  /// Derives the change from recorded poses (not empty) and the corrected ones. Corrected poses
  /// outside the time of the recorded ones are ignored. Throws std::invalid_argument, saying what
  /// is wrong, if `corrected` is empty or unordered, a pose has a defect, or none can be used.
  ///
  /// `before` is a correction of the same recorded poses, if there was one: what it shares with
  /// `corrected` is taken from it.
  Correction(const TrackedPoses& recorded, const std::vector<StampedPose>& corrected,
             const Correction* before = nullptr);

  /// The poses that a correction moves between, and how it moves all others.
  struct Parts {
    TrackedPoses poses;  ///< see poses(); not empty
    /// From recorded poses in map to corrected ones: before the first and after the last of
    /// `poses`.
    Pose first_change = Pose::Identity(), last_change = Pose::Identity();
  };
  /// Creates the correction that parts() are from. It is the first one: unchanged() is 0.
  explicit Correction(Parts parts) : parts_(std::move(parts)) {}
  /// Returns all that decides what corrected() returns.
  const Parts& parts() const { return parts_; }

  /// Returns where a recorded pose was, according to the corrected trajectory.
  Pose corrected(const TrackedPose& recorded) const;

  /// Returns the number of the first recorded poses whose result is that of the correction before.
  std::size_t unchanged(const TrackedPoses& recorded) const;

  /// Returns the corrected poses within the time of the recorded ones, with their odometry.
  const TrackedPoses& poses() const { return parts_.poses; }

 private:
  Pose T_corrected_odom(std::size_t index) const;

  std::size_t shared_ = 0;  // number of the first poses that the correction before had, too
  Parts parts_;
};

}  // namespace ribbon_mapper
