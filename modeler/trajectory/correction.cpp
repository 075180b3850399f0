// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/trajectory/correction.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "modeler/geometry/pose_defect.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the number of poses that are not later than `time`.
std::size_t count_until(const TrackedPoses& poses, Time time) {
  const std::vector<Time>& stamps = poses.stamps();
  return static_cast<std::size_t>(std::upper_bound(stamps.begin(), stamps.end(), time) -
                                  stamps.begin());
}

double fraction_of(Time time, Time from, Time to) {
  return to_seconds(time - from) / to_seconds(to - from);
}

/// Returns the recorded pose at a time within the recording, interpolated.
TrackedPose recorded_at(const TrackedPoses& recorded, Time time) {
  const std::size_t after = count_until(recorded, time);
  TrackedPose from = recorded[after - 1];
  if (from.in_map.stamp == time || after == recorded.size()) return from;
  const TrackedPose to = recorded[after];
  const double fraction = fraction_of(time, from.in_map.stamp, to.in_map.stamp);
  return {{time, interpolate(from.in_map.T_map_base, to.in_map.T_map_base, fraction)},
          interpolate(from.T_odom_base, to.T_odom_base, fraction)};
}

void require_usable(const std::vector<StampedPose>& trajectory) {
  if (trajectory.empty()) throw std::invalid_argument("the corrected trajectory is empty");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (const auto defect = find_defect(trajectory[i].T_map_base)) {
      throw std::invalid_argument("pose " + std::to_string(i) + " of the corrected trajectory " +
                                  *defect);
    }
    if (i > 0 && trajectory[i].stamp <= trajectory[i - 1].stamp) {
      throw std::invalid_argument("the corrected trajectory's stamps do not increase at pose " +
                                  std::to_string(i) +
                                  ": each pose needs the stamp of its own time");
    }
  }
}

}  // namespace

Correction::Correction(const TrackedPoses& recorded, const std::vector<StampedPose>& corrected,
                       const Correction* before) {
  require_usable(corrected);
  const Time first = recorded.stamps().front(), last = recorded.stamps().back();
  const auto begin = std::find_if(corrected.begin(), corrected.end(),
                                  [&](const StampedPose& pose) { return pose.stamp >= first; });
  const auto end = std::find_if(begin, corrected.end(),
                                [&](const StampedPose& pose) { return pose.stamp > last; });
  parts_.poses.reserve(static_cast<std::size_t>(end - begin));
  auto pose = begin;
  if (before) {
    while (pose != end && before->parts_.poses.holds(shared_, *pose)) ++pose, ++shared_;
    parts_.poses.append_first(shared_, before->parts_.poses);
  }
  for (; pose != end; ++pose) {
    parts_.poses.push_back({*pose, recorded_at(recorded, pose->stamp).T_odom_base});
  }
  if (parts_.poses.empty()) {
    throw std::invalid_argument(
        "no pose of the corrected trajectory lies within the model's time (" +
        std::to_string(to_seconds(first)) + " to " + std::to_string(to_seconds(last)) +
        " s): is it of another run?");
  }
  const auto change_at = [&](std::size_t index) {
    const StampedPose now = parts_.poses[index].in_map;
    const Pose T_map_base = recorded_at(recorded, now.stamp).in_map.T_map_base;
    return now.T_map_base * T_map_base.inverse(Eigen::Isometry);
  };
  parts_.first_change = change_at(0), parts_.last_change = change_at(parts_.poses.size() - 1);
}

Pose Correction::corrected(const TrackedPose& recorded) const {
  const Time stamp = recorded.in_map.stamp;
  const std::size_t after = count_until(parts_.poses, stamp), from = after - 1;
  if (after == 0) return parts_.first_change * recorded.in_map.T_map_base;
  if (parts_.poses.stamps()[from] == stamp) return parts_.poses.T_map_base()[from];
  if (after == parts_.poses.size()) return parts_.last_change * recorded.in_map.T_map_base;
  // Interpolated at the robot's position: at the map's origin, rotations would act over a lever
  // arm.
  return interpolate(T_corrected_odom(from) * recorded.T_odom_base,
                     T_corrected_odom(after) * recorded.T_odom_base,
                     fraction_of(stamp, parts_.poses.stamps()[from], parts_.poses.stamps()[after]));
}

std::size_t Correction::unchanged(const TrackedPoses& recorded) const {
  return shared_ == 0 ? 0 : count_until(recorded, parts_.poses.stamps()[shared_ - 1]);
}

Pose Correction::T_corrected_odom(std::size_t index) const {
  const TrackedPose pose = parts_.poses[index];
  return pose.in_map.T_map_base * pose.T_odom_base.inverse(Eigen::Isometry);
}

}  // namespace ribbon_mapper
