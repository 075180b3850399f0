// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "modeler/scan/laser_beams.hpp"
#include "slam/level/level_tracker.hpp"
#include "slam/lines/odometry_source.hpp"

namespace ribbon_mapper::slam {

/// Settings of an odometry that a level laser refines.
struct LevelOdometryConfig {
  LevelScanConfig scan;                ///< see there
  TrackerConfig tracker;               ///< see there
  MatchConfig match;                   ///< see there
  PlanarOdometryNoiseConfig odometry;  ///< see there

  /// A scan is matched if the base has moved so much since the last matched one [m]. Half of what
  /// a match errs by: matching a robot that stands would add noise to a motion of none.
  double moved_m = 0.001;
  double moved_rad = 0.001;  ///< or turned so much [rad]: as far at 1 m

  /// A scan is also matched after so much time [s]: the base may have been pushed.
  double patience_s = 0.5;

  /// After so much time without a scan [s], a moving base counts as not seen: four scans of the
  /// PR2's laser, of which one may be dropped.
  double gap_s = 0.1;
};

/// Odometry whose motion in the plane is corrected by the points of a level laser.
///
/// Each scan is tracked against the keyframes of the last metres, see LevelTracker; the odometry is
/// the prior, which remains where points leave a direction open, and so does its noise there.
/// Between two scans the motion is the odometry's, and the difference is spread evenly. Height,
/// roll and pitch are the odometry's.
class LevelOdometry : public OdometrySource {
 public:
  /// Starts without scans: the odometry as it is.
  explicit LevelOdometry(const LevelOdometryConfig& config);

  /// Returns true if a scan with this stamp would be used, with the base at this pose in odom.
  /// Others need not be added.
  bool is_due(Time stamp, const Pose& T_odom_base) const;

  /// Adds a scan, in order of stamps; it is left out if it is not due. Of the poses, those in odom
  /// and that of the laser at the first beam are used. Throws std::invalid_argument if the stamp is
  /// not later than the last, a pose is not valid, or the laser is not level; nothing is changed.
  void add_scan(const LaserBeams& beams, const LinePoses& poses);

  /// Returns the refined pose. Before the first scan, it is the recorded one; after the last one,
  /// the recorded motion is added.
  Pose T_odom_base(Time stamp, const Pose& recorded) const override;

  /// Returns the covariance by the points. Two scans that are a keyframe apart err independently;
  /// what lies between shares this evenly by its way. A motion over missing scans is not measured.
  Eigen::Matrix3d step_covariance(Time from, Time to, const Pose& step) const override;

  /// Returns the number of scans that were matched, the first among them.
  std::size_t matched() const { return scans_.size(); }
  /// Returns the tracker.
  const LevelTracker& tracker() const { return tracker_; }

 private:
  /// A scan that was matched.
  struct MatchedScan {
    Time stamp{0};                  // of its middle
    PlanarPose recorded;            // base in odom, at the first beam
    PlanarPose T_refined_recorded;  // takes a pose from the recorded odom to the refined one
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of a motion between two keyframes
    bool is_gap = true;  // it is not known how the base has moved since the scan before
  };
  bool has_moved(const MatchedScan& since, const PlanarPose& recorded) const;
  bool is_gap(Time stamp, const PlanarPose& recorded) const;
  /// Returns the first scan after a time.
  std::vector<MatchedScan>::const_iterator after(Time stamp) const;

  LevelOdometryConfig config_;
  LevelTracker tracker_;
  std::vector<MatchedScan> scans_;
  PlanarPose T_odom_start_;  // origin of the tracker
};

}  // namespace ribbon_mapper::slam
