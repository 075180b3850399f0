// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/level_tracker.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ribbon_mapper::slam {
namespace {

constexpr double kSearchSpacing_m = 0.15;
/// Least information of a pose from which odometry is judged: to 3 cm in all directions.
constexpr double kMoved_m = 0.02, kMoved_rad = 0.02;  // standing still tells nothing of odometry
constexpr double kWellObserved = 1.0 / (0.03 * 0.03);
constexpr double kRegular = 1e-3;  // information that no sensor is worse than

/// Returns the least information of a position in any direction.
double least_information(const Eigen::Matrix3d& information) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(information.topLeftCorner<2, 2>(),
                                                        Eigen::EigenvaluesOnly)
      .eigenvalues()(0);
}

/// Returns how far a match is from where odometry expects the robot: x, y, yaw in map.
Eigen::Vector3d off_prior(const Match& found, const PosePrior& prior) {
  Eigen::Vector3d off = found.T_map_base.vector() - prior.T_map_base.vector();
  off.z() = wrapped(off.z());
  return off;
}

/// Returns the same for the points alone: the match is a weighted mean of these and of odometry.
Eigen::Vector3d points_off_prior(const Match& found, const PosePrior& prior) {
  const Eigen::Vector3d off = off_prior(found, prior);
  return off + found.information.ldlt().solve(found.prior_information * off);
}

/// Returns where the points alone see the robot, from where odometry does.
PlanarPose innovation(const Match& found, const PosePrior& prior) {
  const PlanarPose& expected = prior.T_map_base;
  return relative(expected, planar(expected.vector() + points_off_prior(found, prior)));
}

/// Returns the pose of a match if its points count with `information` only. Where that is zero, the
/// pose is the expected one (solution remapping: Zhang, Kaess and Singh, 'On degeneracy of
/// optimization-based state estimation problems', ICRA 2016).
PlanarPose remapped(const Match& found, const Eigen::Matrix3d& information,
                    const PosePrior& prior) {
  const Eigen::Matrix3d both =
      information + found.prior_information + kRegular * Eigen::Matrix3d::Identity();
  return planar(prior.T_map_base.vector() +
                both.ldlt().solve(information * points_off_prior(found, prior)));
}

/// Returns an information of x, y, yaw that is given in a source, in target.
Eigen::Matrix3d turned(const Eigen::Matrix3d& information, double yaw_target_source) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(yaw_target_source).toRotationMatrix();
  return R * information * R.transpose();
}

}  // namespace

TrackedScan LevelTracker::add(const LevelScan& scan, const PlanarPose& T_odom_base) {
  TrackedScan tracked;
  if (keyframes_.empty()) {
    tracked.is_keyframe = true;
    T_odom_last_ = T_odom_keyframe_ = T_odom_base;
    add_keyframe(scan, tracked, Eigen::Matrix3d::Identity());
    return tracked;
  }
  ++scans_;
  const PlanarPose step = relative(T_odom_last_, T_odom_base);
  PosePrior prior{T_keyframe_last_ * step, Eigen::Matrix3d::Zero()};
  prior.information = turned(noise_.information(step), prior.T_map_base.yaw_rad);
  Match found = match(scan.points, *map_, prior.T_map_base, prior, match_);
  if (found.points > 0 && found.agreeing < config_.lost_below) {
    found = searched(scan.points, found, prior);
  }
  const bool has_moved =
      step.translation().norm() > kMoved_m || std::abs(step.yaw_rad) > kMoved_rad;
  if (has_moved && least_information(found.information) > kWellObserved)
    noise_.learn(step, innovation(found, prior));
  const Eigen::Matrix3d information = information_beyond_normals(found, match_);
  found.T_map_base = remapped(found, information, prior);
  tracked = {keyframes_.size() - 1, found.T_map_base, found.agreeing, false,
             turned(information, -found.T_map_base.yaw_rad)};
  T_odom_last_ = T_odom_base, T_keyframe_last_ = found.T_map_base;
  const bool is_far = tracked.T_keyframe_base.translation().norm() > config_.keyframe_m ||
                      std::abs(tracked.T_keyframe_base.yaw_rad) > config_.keyframe_rad;
  if (!is_far) return tracked;
  // the way from the keyframe by odometry, for what the points leave open
  const Eigen::Matrix3d odometry =
      turned(noise_.information(relative(T_odom_keyframe_, T_odom_base)), found.T_map_base.yaw_rad);
  T_odom_keyframe_ = T_odom_base;
  add_keyframe(scan, tracked, found.information + odometry);
  tracked.keyframe = keyframes_.size() - 1, tracked.T_keyframe_base = {};
  tracked.is_keyframe = true;
  return tracked;
}

Match LevelTracker::searched(const LevelPoints& points, const Match& lost, const PosePrior& prior) {
  if (!search_) search_ = std::make_unique<CorrelativeSearch>(reference_);
  const bool is_astray = lost.agreeing < config_.astray_below;
  SearchWindow window;
  window.radius_m = is_astray ? config_.astray_search_m : config_.search_m;
  window.angle_rad = is_astray ? config_.astray_search_rad : config_.search_rad;
  window.least_score = 0.3;
  const LevelPoints few = thinned(points, kSearchSpacing_m);
  Match best = lost;
  // odometry may have jumped: the robot is then near its last pose
  for (const PlanarPose& guess : {prior.T_map_base, T_keyframe_last_}) {
    const auto hit = search_->find(few, guess, window, 0.0);
    if (!hit) continue;
    const PosePrior weak{hit->T_map_base, 1e-2 * prior.information};  // the search overruled it
    const Match found = match(points, *map_, hit->T_map_base, weak, match_);
    if (found.agreeing > best.agreeing) best = found;
  }
  if (best.agreeing < lost.agreeing + config_.better_by) return lost;
  ++searches_;
  return best;
}

void LevelTracker::add_keyframe(const LevelScan& scan, const TrackedScan& tracked,
                                const Eigen::Matrix3d& information) {
  Keyframe keyframe;
  keyframe.scan = scans_;
  keyframe.points = scan.points;
  keyframe.T_before_base = tracked.T_keyframe_base;
  keyframe.T_track_base = tracked.T_keyframe_base;
  keyframe.information = information;
  if (!keyframes_.empty()) {
    keyframe.T_track_base = keyframes_.back().T_track_base * tracked.T_keyframe_base;
    keyframe.way_m = keyframes_.back().way_m + tracked.T_keyframe_base.translation().norm();
  }
  keyframes_.push_back(std::move(keyframe));
  T_keyframe_last_ = {};
  make_map();
}

void LevelTracker::make_map() {
  const Keyframe& newest = keyframes_.back();
  reference_.clear();
  for (auto k = keyframes_.rbegin(); k != keyframes_.rend(); ++k) {
    if (newest.way_m - k->way_m > config_.reference_m) break;
    append_moved(k->points, relative(newest.T_track_base, k->T_track_base), reference_);
  }
  map_ = std::make_unique<SurfaceMap>(reference_);
  search_.reset();
}

}  // namespace ribbon_mapper::slam
