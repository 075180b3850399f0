// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/observations/observations.hpp"
#include "slam/lines/noise_scale.hpp"
#include "slam/places/relocaliser.hpp"
#include "slam/tilting/line_tracker.hpp"

namespace ribbon_mapper::slam {

/// Estimates the trajectory of a tilting laser from odometry and ribbons alone.
///
/// Each line is tracked against the planes that are known. Every few seconds, the newest poses are
/// adjusted together with all planes around them, old ones among these, which closes loops within
/// the gates. finish() adjusts all poses and planes. docs/slam.md explains the method.
///
/// The estimate starts at the odometry's pose of the first line. It has no thread and no clock.
class TrajectoryEstimate {
 public:
  /// Starts without lines. `observations` hold the lines to come and must outlive this; their
  /// poses in map are not used. `odometry` takes the place of the recorded one unless it is null,
  /// and must then outlive this, too.
  TrajectoryEstimate(const Observations& observations, const EstimateSettings& settings,
                     const OdometrySource* odometry = nullptr);

  /// Takes the lines that the observations have gained. Must be called after each line if the
  /// observations may be thinned. Returns true if poses of older lines were revised.
  bool update();

  /// Adjusts the whole trajectory. Lines may follow.
  void finish();

  /// Returns the estimated pose of the base for each line, in odom as it was at the first line.
  std::vector<StampedPose> trajectory() const;

  /// Returns the last pose of trajectory(). There must be a line.
  StampedPose newest_pose() const { return pose(lines_.size() - 1); }

  /// Computes the covariances of trajectory(), a pose each, for errors as those of PoseBelief in
  /// the same frame. That of the first pose is zero: it defines the frame. Takes about the time of
  /// a third of finish(). docs/slam.md says what they contain.
  std::vector<Matrix6> covariances() const;

  /// Returns the covariance of newest_pose(), as tracked, in the frame of the first line's base.
  const Matrix6& covariance() const { return tracker_.belief().covariance; }

  /// Returns true while the robot may be on known ground at a wrong pose.
  bool is_lost() const { return relocaliser_.is_lost(); }
  /// Returns all decisions about where the robot is, in their order.
  const std::vector<Decision>& decisions() const { return relocaliser_.decisions(); }

  /// Returns the number of lines that were taken.
  std::size_t size() const { return lines_.size(); }

  /// Returns the learnt scale of the odometry's noise, see OdometryNoise::planar_scale.
  double noise_scale() const { return noise_.planar_scale; }

 private:
  StampedPose pose(std::uint32_t line) const {
    return {lines_.stamp(line), T_odom_start_ * lines_.T_start_base(line)};
  }
  void adjust_window();
  void restart_tracker(std::vector<std::uint32_t> context, std::uint32_t first);
  void learn_noise(std::uint32_t first_of_window);
  std::vector<std::uint32_t> context_before(std::uint32_t first) const;

  EstimateSettings settings_;
  NoiseScale noise_scale_;
  OdometryNoise noise_;
  PosedLines lines_;
  LineTracker tracker_;
  Relocaliser relocaliser_;
  Pose T_odom_start_ = Pose::Identity();
  Time last_window_{0};           // stamp of the line at which the last window was adjusted
  std::vector<Matrix6> tracked_;  // covariances of the newest lines when they were tracked
  std::uint32_t settled_ = 0;     // lines before it have left all windows
};

}  // namespace ribbon_mapper::slam
