// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/pose_history.hpp"

#include <algorithm>

namespace ribbon_mapper {

void PoseHistory::add(const StampedPose& pose) {
  if (!empty() && pose.stamp < newest().stamp) poses_.clear();
  if (empty() || pose.stamp > newest().stamp) poses_.push_back(pose);
}

std::optional<Pose> PoseHistory::at(Time time) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), time,
                       [](const StampedPose& pose, Time stamp) { return pose.stamp < stamp; });
  if (after == poses_.end()) return std::nullopt;
  if (after->stamp == time) return after->T_map_base;
  if (after == poses_.begin()) return std::nullopt;
  const StampedPose& before = *(after - 1);
  const double fraction = to_seconds(time - before.stamp) / to_seconds(after->stamp - before.stamp);
  return interpolate(before.T_map_base, after->T_map_base, fraction);
}

std::vector<StampedPose> PoseHistory::at_stamps_of(
    const std::vector<StampedPose>& trajectory) const {
  std::vector<StampedPose> result;
  for (const StampedPose& pose : trajectory) {
    if (const std::optional<Pose> here = at(pose.stamp)) result.push_back({pose.stamp, *here});
  }
  return result;
}

}  // namespace ribbon_mapper
