// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Compares how a corrected trajectory turns with how odometry turned. Odometry slips, but hardly
/// by half of a turn. A trajectory that turns elsewhere has its quaternions in another order, is
/// that of another frame (a camera's), of another run, or has no rotation at all.
class TurnCheck {
 public:
  /// Adds a pose of odometry, later than the last one.
  void add(Time stamp, const Pose& T_odom_base);
  /// Forgets all poses.
  void clear() { headings_.clear(); }

  /// Returns a sentence if the turns of a trajectory contradict odometry; nothing if they agree, or
  /// if there are too few turns to tell. The trajectory is cut into stretches in which it or
  /// odometry turns by 10 degrees. The rotations between both ends of a stretch are compared. There
  /// is a contradiction if the angles between them sum up to half of the angles turned.
  std::optional<std::string> contradiction(const std::vector<StampedPose>& trajectory) const;

 private:
  struct Heading {
    Time stamp;
    Eigen::Quaternionf R_odom_base;
  };
  std::optional<Eigen::Quaternionf> heading_at(Time stamp) const;

  std::vector<Heading> headings_;  ///< ten a second
};

}  // namespace ribbon_mapper
