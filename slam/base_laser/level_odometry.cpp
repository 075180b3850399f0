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

bool LevelOdometry::has_moved(const MatchedScan& since, const PlanarPose& recorded) const {
  const PlanarPose step = relative(since.recorded, recorded);
  return step.translation().norm() > config_.moved_m || std::abs(step.yaw_rad) > config_.moved_rad;
}

bool LevelOdometry::is_due(Time stamp, const Pose& T_odom_base) const {
  return scans_.empty() || has_moved(scans_.back(), in_plane(T_odom_base)) ||
         stamp - scans_.back().stamp > from_seconds(config_.patience_s);
}

void LevelOdometry::add_scan(const LaserBeams& beams, const LinePoses& poses) {
  require_usable(beams, poses, config_.scan);
  if (!scans_.empty() && beams.stamp <= scans_.back().stamp)
    throw std::invalid_argument("a level scan is not later than the one before: leave it out");
  if (!is_due(beams.stamp, poses.T_odom_base_first)) return;
  const PlanarPose recorded = in_plane(poses.T_odom_base_first);
  const LevelScan scan =
      level_scan_of(beams, poses.T_base_laser_first,
                    relative(recorded, in_plane(poses.T_odom_base_last)), config_.scan);
  const TrackedScan tracked = tracker_.add(scan, recorded);
  if (scans_.empty()) T_odom_start_ = recorded;
  const PlanarPose refined =
      T_odom_start_ * tracker_.keyframes()[tracked.keyframe].T_track_base * tracked.T_keyframe_base;
  const bool is_sure =
      tracked.agreeing >= config_.tracker.lost_below && tracked.observed >= config_.open_below;
  scans_.push_back({beams.stamp, recorded, refined * inverse(recorded), is_sure});
}

bool LevelOdometry::is_refined(const MatchedScan& last, Time stamp,
                               const PlanarPose& recorded) const {
  return last.is_sure &&
         (stamp - last.stamp <= from_seconds(config_.gap_s) || !has_moved(last, recorded));
}

RefinedPose LevelOdometry::refined(Time stamp, const Pose& recorded) const {
  const auto next =
      std::upper_bound(scans_.begin(), scans_.end(), stamp,
                       [](Time time, const MatchedScan& scan) { return time < scan.stamp; });
  if (next == scans_.begin()) return {recorded, false};
  const MatchedScan& last = *(next - 1);
  // Two scans move it alike near the base, but not at the origin of odom, which may be far away.
  const PlanarPose base = in_plane(recorded), by_last = last.T_refined_recorded * base;
  PlanarPose pose = by_last;
  if (next != scans_.end()) {
    const double fraction = to_seconds(stamp - last.stamp) / to_seconds(next->stamp - last.stamp);
    pose = between(by_last, next->T_refined_recorded * base, fraction);
  }
  return {in_space(pose * inverse(base)) * recorded, is_refined(last, stamp, base)};
}

}  // namespace ribbon_mapper::slam
