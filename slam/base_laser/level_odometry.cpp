// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/base_laser/level_odometry.hpp"

#include <algorithm>
#include <stdexcept>

namespace ribbon_mapper::slam {
namespace {

PlanarPose in_plane(const Pose& pose) {
  return {pose.translation().x(), pose.translation().y(), yaw_of(pose)};
}

Pose in_space(const PlanarPose& pose) { return planar_pose(pose.x_m, pose.y_m, pose.yaw_rad); }

/// Returns the pose at a fraction of the way between two that are close to each other.
PlanarPose between(const PlanarPose& from, const PlanarPose& to, double fraction) {
  return from * planar(fraction * relative(from, to).vector());
}

void require_usable(const LaserBeams& beams, const LinePoses& poses, const LevelScanConfig& scan) {
  if (!is_valid(poses.T_odom_base_first) || !is_valid(poses.T_odom_base_last) ||
      !is_valid(poses.T_base_laser_first))
    throw std::invalid_argument("a pose of a level scan is not valid: leave the scan out");
  if (!is_level(poses.T_base_laser_first, scan))
    throw std::invalid_argument("the laser is not level: give the topic of one that is");
  if (!std::isfinite(beams.angle_min_rad) || !std::isfinite(beams.angle_increment_rad))
    throw std::invalid_argument("the angles of a level scan are not finite: leave the scan out");
}

}  // namespace

LevelOdometry::LevelOdometry(const LevelOdometryConfig& config)
    : config_(config), tracker_(config.tracker, config.match, config.odometry) {}

bool LevelOdometry::is_due(Time stamp, const Pose& T_odom_base) const {
  if (refined_.empty()) return true;
  const Pose step = T_odom_last_.inverse(Eigen::Isometry) * T_odom_base;
  return step.translation().norm() > config_.moved_m || angle_of(step) > config_.moved_rad ||
         stamp - refined_.back().stamp > from_seconds(config_.patience_s);
}

void LevelOdometry::add_scan(const LaserBeams& beams, const LinePoses& poses) {
  require_usable(beams, poses, config_.scan);
  if (!refined_.empty() && beams.stamp <= refined_.back().stamp)
    throw std::invalid_argument("a level scan is not later than the one before: leave it out");
  if (!is_due(beams.stamp, poses.T_odom_base_first)) return;
  const PlanarPose recorded = in_plane(poses.T_odom_base_first);
  const LevelScan scan =
      level_scan_of(beams, poses.T_base_laser_first,
                    relative(recorded, in_plane(poses.T_odom_base_last)), config_.scan);
  const TrackedScan tracked = tracker_.add(scan, recorded);
  if (refined_.empty()) T_refined_start_ = recorded;
  const PlanarPose refined = T_refined_start_ *
                             tracker_.keyframes()[tracked.keyframe].T_track_base *
                             tracked.T_keyframe_base;
  refined_.push_back({beams.stamp, refined * inverse(recorded)});
  T_odom_last_ = poses.T_odom_base_first;
}

Pose LevelOdometry::T_odom_base(Time stamp, const Pose& recorded) const {
  const auto next =
      std::upper_bound(refined_.begin(), refined_.end(), stamp,
                       [](Time time, const Refined& scan) { return time < scan.stamp; });
  if (next == refined_.begin()) return recorded;
  const Refined& last = *(next - 1);
  if (next == refined_.end()) return in_space(last.T_refined_recorded) * recorded;
  // The two differ little at the pose, and much at the origin of odom, if that is far away.
  const PlanarPose pose = in_plane(recorded);
  const PlanarPose by_last = last.T_refined_recorded * pose,
                   by_next = next->T_refined_recorded * pose;
  const double fraction = to_seconds(stamp - last.stamp) / to_seconds(next->stamp - last.stamp);
  return in_space(between(by_last, by_next, fraction) * inverse(pose)) * recorded;
}

}  // namespace ribbon_mapper::slam
