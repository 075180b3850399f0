// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "slam/level/odometry_noise.hpp"
#include "slam/matching/correlative_search.hpp"
#include "slam/matching/scan_matcher.hpp"

namespace ribbon_mapper::slam {

/// Settings for tracking.
struct TrackerConfig {
  double keyframe_m = 0.4;         ///< a new keyframe after so much way: surfaces overlap well
  double keyframe_rad = 0.35;      ///< or turning
  double reference_m = 6.0;        ///< way of the keyframes that scans are matched against
  double lost_below = 0.7;         ///< share of agreeing points; with less, a search is made
  double search_m = 0.4;           ///< its reach: a wider one slides along corridors
  double search_rad = 0.6;         ///< its reach
  double astray_below = 0.35;      ///< share of agreeing points; with less, the reach is
  double astray_search_m = 1.5;    ///< this: odometry stood still and jumped
  double astray_search_rad = 1.0;  ///< and this
  double better_by = 0.1;          ///< what a search must gain in agreeing points
};

/// A scan that is kept for matching, with its way from the one before.
struct Keyframe {
  std::size_t scan = 0;      ///< its number
  LevelPoints points;        ///< in base
  PlanarPose T_track_base;   ///< pose of the tracker, which drifts
  PlanarPose T_before_base;  ///< as seen from the keyframe before; of the first: T_track
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of T_before_base
  double way_m = 0.0;                                     ///< from the first keyframe
};

/// Where a scan is.
struct TrackedScan {
  std::size_t keyframe = 0;    ///< the newest one before or at the scan
  PlanarPose T_keyframe_base;  ///< pose as seen from it
  double agreeing = 1.0;       ///< share of points that agree with the map
  bool is_keyframe = false;    ///< whether this scan is the keyframe
  /// Of x, y and yaw by the points alone, along the axes of the base. It is zero in directions that
  /// they leave open, such as along a corridor.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// Follows the robot: odometry predicts, and each scan is matched against the latest keyframes.
class LevelTracker {
 public:
  /// Creates a tracker whose first scan is its origin.
  LevelTracker(const TrackerConfig& config, const MatchConfig& match,
               const PlanarOdometryNoiseConfig& noise)
      : config_(config), match_(match), noise_(noise) {}

  /// Takes in a scan with the pose of odometry at its time, and returns where it is.
  TrackedScan add(const LevelScan& scan, const PlanarPose& T_odom_base);

  /// Returns all keyframes.
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }
  /// Returns what was learnt about the odometry.
  const PlanarOdometryNoise& noise() const { return noise_; }
  /// Returns how many scans a search has put right.
  std::size_t searches() const { return searches_; }

 private:
  Match searched(const LevelPoints& points, const Match& lost, const PosePrior& prior);
  void add_keyframe(const LevelScan& scan, const TrackedScan& tracked,
                    const Eigen::Matrix3d& information);
  void make_map();

  TrackerConfig config_;
  MatchConfig match_;
  PlanarOdometryNoise noise_;
  std::vector<Keyframe> keyframes_;
  LevelPoints reference_;                      ///< latest keyframes, in the newest
  std::unique_ptr<SurfaceMap> map_;            ///< of these
  std::unique_ptr<CorrelativeSearch> search_;  ///< of these, made when needed
  PlanarPose T_odom_last_, T_keyframe_last_;
  PlanarPose T_odom_keyframe_;
  std::size_t scans_ = 0, searches_ = 0;
};

}  // namespace ribbon_mapper::slam
