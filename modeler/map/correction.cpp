// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/correction.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ribbon_mapper {
namespace {

bool is_before(Time time, const StampedPose& pose) { return time < pose.stamp; }

/// Pose at a time within the trajectory's.
Pose pose_at(const std::vector<StampedPose>& trajectory, Time time) {
  const auto after = std::upper_bound(trajectory.begin(), trajectory.end(), time, is_before);
  const StampedPose& from = *(after - 1);
  if (from.stamp == time || after == trajectory.end()) return from.T_map_base;
  const double fraction = to_seconds(time - from.stamp) / to_seconds(after->stamp - from.stamp);
  return interpolate(from.T_map_base, after->T_map_base, fraction);
}

void require_usable(const std::vector<StampedPose>& trajectory) {
  if (trajectory.empty()) throw std::invalid_argument("the corrected trajectory is empty");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!is_valid(trajectory[i].T_map_base)) {
      throw std::invalid_argument("pose " + std::to_string(i) +
                                  " of the corrected trajectory is not finite or not rigid");
    }
    if (i > 0 && trajectory[i].stamp <= trajectory[i - 1].stamp) {
      throw std::invalid_argument(
          "the corrected trajectory's stamps do not increase at pose " + std::to_string(i) +
          ": each pose needs the stamp of its own time");
    }
  }
}

}  // namespace

Correction::Correction(const std::vector<StampedPose>& recorded,
                       const std::vector<StampedPose>& corrected) {
  require_usable(corrected);
  for (const StampedPose& pose : corrected) {
    if (pose.stamp < recorded.front().stamp || pose.stamp > recorded.back().stamp) continue;
    const Pose T_recorded_map = pose_at(recorded, pose.stamp).inverse(Eigen::Isometry);
    changes_.push_back({pose.stamp, pose.T_map_base * T_recorded_map});
  }
  if (changes_.empty()) {
    throw std::invalid_argument(
        "no pose of the corrected trajectory lies within the model's time (" +
        std::to_string(to_seconds(recorded.front().stamp)) + " to " +
        std::to_string(to_seconds(recorded.back().stamp)) + " s): is it of another run?");
  }
}

Pose Correction::corrected(const StampedPose& recorded) const {
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), recorded.stamp, is_before);
  if (after == changes_.begin()) return after->T_map_base * recorded.T_map_base;
  const StampedPose& from = *(after - 1);
  if (after == changes_.end()) return from.T_map_base * recorded.T_map_base;
  // The change of the position is that at the robot's own place, not at the map's origin.
  const double fraction =
      to_seconds(recorded.stamp - from.stamp) / to_seconds(after->stamp - from.stamp);
  return interpolate(from.T_map_base * recorded.T_map_base,
                     after->T_map_base * recorded.T_map_base, fraction);
}

}  // namespace ribbon_mapper
