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

/// The trajectory of a localisation that says only where odom is in map (gmapping, amcl,
/// slam_toolbox): each time it changes its mind, what it says is the truth of that moment. In
/// between it repeats itself while odometry drifts, so only the changes are poses of the
/// trajectory.
class TfHistory {
 public:
  explicit TfHistory(const Frames& frames) : frames_(frames) {}

  /// A new transform map -> odom. Stamps that a localisation dates into the future are waited for.
  void take(Time stamp, const Pose& T_map_odom);

  /// Looks up where the base was when odom was corrected.
  void look_up(const tf2::BufferCore& tf);

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
