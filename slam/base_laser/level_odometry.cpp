// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/base_laser/level_odometry.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

namespace ribbon_mapper::slam {
namespace {

// Points are placed as if the base had moved evenly. A random walk departs from the straight way
// between its ends by a sixth of its variance, on average (Brownian bridge).
constexpr double kWithinScan = 1.0 / 6.0;

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

/// Returns the covariance of a motion whose two ends are seen as a scan is. The base moves by
/// `within` during the scan.
Eigen::Matrix3d covariance_of(const TrackedScan& scan, const PlanarPose& within,
                              const PlanarOdometryNoise& noise, const TrackerConfig& config) {
  if (scan.agreeing < config.lost_below) return Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d regular = 0.5 * scan.information + Eigen::Matrix3d::Identity();
  return regular.inverse() + 2.0 * kWithinScan * noise.information(within).inverse();
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
  const Time middle = middle_of(beams);
  if (!scans_.empty() && middle <= scans_.back().stamp)
    throw std::invalid_argument("a level scan is not later than the one before: leave it out");
  if (!is_due(middle, poses.T_odom_base_first)) return;
  const PlanarPose recorded = in_plane(poses.T_odom_base_first);
  const PlanarPose within = relative(recorded, in_plane(poses.T_odom_base_last));
  const LevelScan scan = level_scan_of(beams, poses.T_base_laser_first, within, config_.scan);
  const TrackedScan tracked = tracker_.add(scan, recorded);
  if (scans_.empty()) T_odom_start_ = recorded;
  const PlanarPose refined =
      T_odom_start_ * tracker_.keyframes()[tracked.keyframe].T_track_base * tracked.T_keyframe_base;
  // An error of the motion within the scan turns the match by half of it, as it does the middle.
  scans_.push_back({middle, recorded, refined * inverse(recorded),
                    covariance_of(tracked, within, tracker_.noise(), config_.tracker),
                    is_gap(middle, recorded)});
}

/// Returns true if the base may have moved unseen since the last scan.
bool LevelOdometry::is_gap(Time stamp, const PlanarPose& recorded) const {
  if (scans_.empty()) return true;
  const MatchedScan& last = scans_.back();
  return stamp - last.stamp > from_seconds(config_.gap_s) && has_moved(last, recorded);
}

std::vector<LevelOdometry::MatchedScan>::const_iterator LevelOdometry::after(Time stamp) const {
  return std::upper_bound(scans_.begin(), scans_.end(), stamp,
                          [](Time time, const MatchedScan& scan) { return time < scan.stamp; });
}

Pose LevelOdometry::T_odom_base(Time stamp, const Pose& recorded) const {
  const auto next = after(stamp);
  if (next == scans_.begin()) return recorded;
  const MatchedScan& last = *(next - 1);
  // Two scans move it alike near the base, but not at the origin of odom, which may be far away.
  const PlanarPose base = in_plane(recorded), by_last = last.T_refined_recorded * base;
  PlanarPose pose = by_last;
  if (next != scans_.end()) {
    const double fraction = to_seconds(stamp - last.stamp) / to_seconds(next->stamp - last.stamp);
    pose = between(by_last, next->T_refined_recorded * base, fraction);
  }
  return in_space(pose * inverse(base)) * recorded;
}

Eigen::Matrix3d LevelOdometry::step_covariance(Time from, Time to, const Pose& step) const {
  const double way = step.translation().norm() / config_.tracker.keyframe_m +
                     angle_of(step) / config_.tracker.keyframe_rad;
  const auto begin = after(from), end = after(to);
  bool is_seen = begin != scans_.begin() && end != scans_.begin();
  is_seen = is_seen && std::none_of(begin, end, [](const MatchedScan& s) { return s.is_gap; });
  // A motion after the last scan is the recorded one.
  is_seen = is_seen && (way < 1e-3 || to - (end - 1)->stamp <= from_seconds(config_.gap_s));
  if (!is_seen) return Eigen::Matrix3d::Identity();
  return way * (end - 1)->covariance;
}

}  // namespace ribbon_mapper::slam
