// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Where the robot was, from its poses as they came in.
class PoseHistory {
 public:
  /// A pose that is older than the newest one starts the history anew: time was set back.
  void add(const StampedPose& pose);

  /// Interpolated; nothing outside the history.
  std::optional<Pose> at(Time time) const;

  /// `trajectory` with the poses of this history at its stamps; stamps outside are left out.
  std::vector<StampedPose> at_stamps_of(const std::vector<StampedPose>& trajectory) const;

  bool empty() const { return poses_.empty(); }
  const StampedPose& newest() const { return poses_.back(); }

 private:
  std::vector<StampedPose> poses_;
};

}  // namespace ribbon_mapper
