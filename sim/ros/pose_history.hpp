// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// The poses of the robot in one run of simulated time, in order of their stamps.
class PoseHistory {
 public:
  /// Adds a pose. A pose older than the newest one empties the history first: time was set back.
  void add(const StampedPose& pose);

  /// Returns the interpolated pose; nothing outside the history.
  std::optional<Pose> at(Time time) const;

  /// Returns the poses of this history at the stamps of `trajectory`. Leaves out stamps outside.
  std::vector<StampedPose> at_stamps_of(const std::vector<StampedPose>& trajectory) const;

  /// Returns whether there is no pose yet.
  bool empty() const { return poses_.empty(); }
  /// Returns the newest pose. The history must not be empty.
  const StampedPose& newest() const { return poses_.back(); }

 private:
  std::vector<StampedPose> poses_;
};

}  // namespace ribbon_mapper
