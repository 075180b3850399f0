// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <deque>
#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/ros/intake/line_poses.hpp"

namespace ribbon_mapper {

/// Builds a trajectory from a localisation that publishes only the transform map -> odom (gmapping,
/// amcl, slam_toolbox). A changed transform is an estimate of that moment. In between the
/// localisation repeats itself while odometry drifts, so only changes become poses.
class TfHistory {
 public:
  /// Creates an empty history.
  explicit TfHistory(const Frames& frames) : frames_(frames) {}

  /// Adds a transform map -> odom. A stamp in the future waits for odometry.
  void take(Time stamp, const Pose& T_map_odom);

  /// Looks up odometry at the stamps of the changes and extends the trajectory.
  void look_up(const tf2::BufferCore& tf);

  /// Returns the poses of the base in map, stamps strictly increasing.
  const std::vector<StampedPose>& trajectory() const { return trajectory_; }

 private:
  struct Waiting {
    Time stamp;
    Pose T_map_odom;
  };
  Frames frames_;
  std::optional<Pose> last_T_map_odom_;
  std::deque<Waiting> waiting_;
  std::vector<StampedPose> trajectory_;
};

}  // namespace ribbon_mapper
