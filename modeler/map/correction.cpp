// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/correction.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ribbon_mapper {
namespace {

/// The recorded pose at a time within the recording's, interpolated.
RecordedPose recorded_at(const std::vector<RecordedPose>& recorded, Time time) {
  const auto is_before = [](Time t, const RecordedPose& pose) { return t < pose.in_map.stamp; };
  const auto after = std::upper_bound(recorded.begin(), recorded.end(), time, is_before);
  const RecordedPose& from = *(after - 1);
  if (from.in_map.stamp == time || after == recorded.end()) return from;
  const double fraction =
      to_seconds(time - from.in_map.stamp) / to_seconds(after->in_map.stamp - from.in_map.stamp);
  return {{time, interpolate(from.in_map.T_map_base, after->in_map.T_map_base, fraction)},
          interpolate(from.T_odom_base, after->T_odom_base, fraction)};
}

void require_usable(const std::vector<StampedPose>& trajectory) {
  if (trajectory.empty()) throw std::invalid_argument("the corrected trajectory is empty");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!is_valid(trajectory[i].T_map_base)) {
      throw std::invalid_argument("pose " + std::to_string(i) +
                                  " of the corrected trajectory is not finite or not rigid");
    }
    if (i > 0 && trajectory[i].stamp <= trajectory[i - 1].stamp) {
      throw std::invalid_argument("the corrected trajectory's stamps do not increase at pose " +
                                  std::to_string(i) +
                                  ": each pose needs the stamp of its own time");
    }
  }
}

}  // namespace

Correction::Correction(const std::vector<RecordedPose>& recorded,
                       const std::vector<StampedPose>& corrected) {
  require_usable(corrected);
  const Time first = recorded.front().in_map.stamp, last = recorded.back().in_map.stamp;
  changes_.reserve(corrected.size());
  poses_.reserve(corrected.size());
  for (const StampedPose& pose : corrected) {
    if (pose.stamp < first || pose.stamp > last) continue;
    const RecordedPose was = recorded_at(recorded, pose.stamp);
    changes_.push_back({pose.stamp,
                        pose.T_map_base * was.in_map.T_map_base.inverse(Eigen::Isometry),
                        pose.T_map_base * was.T_odom_base.inverse(Eigen::Isometry)});
    poses_.push_back({pose, was.T_odom_base});
  }
  if (changes_.empty()) {
    throw std::invalid_argument(
        "no pose of the corrected trajectory lies within the model's time (" +
        std::to_string(to_seconds(first)) + " to " + std::to_string(to_seconds(last)) +
        " s): is it of another run?");
  }
}

Pose Correction::corrected(const RecordedPose& recorded) const {
  const Time stamp = recorded.in_map.stamp;
  const auto after =
      std::upper_bound(changes_.begin(), changes_.end(), stamp,
                       [](Time time, const Change& change) { return time < change.stamp; });
  if (after == changes_.begin()) return after->T_corrected_map * recorded.in_map.T_map_base;
  const Change& from = *(after - 1);
  if (from.stamp == stamp) return from.T_corrected_odom * recorded.T_odom_base;
  if (after == changes_.end()) return from.T_corrected_map * recorded.in_map.T_map_base;
  // The change of the position is that at the robot's own place, not at the map's origin.
  const double fraction = to_seconds(stamp - from.stamp) / to_seconds(after->stamp - from.stamp);
  return interpolate(from.T_corrected_odom * recorded.T_odom_base,
                     after->T_corrected_odom * recorded.T_odom_base, fraction);
}

}  // namespace ribbon_mapper
