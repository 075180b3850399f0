// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "modeler/modeler.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "slam/base_laser/level_odometry.hpp"
#include "slam/tilting/trajectory_estimate.hpp"

namespace ribbon_mapper::slam {

/// What became of a line.
struct LineOutcome {
  LineResult result = LineResult::waiting;  ///< see Modeler::add_scan_line()
  std::string defect;                       ///< of a line that is malformed; else empty
  double seconds = 0.0;                     ///< that it took, with windows
};

/// The pose of the robot at its newest line. `map` is odom as it was at the first line.
struct PoseOfNow {
  Time stamp{0};                         ///< of the line
  Pose T_map_base = Pose::Identity();    ///< as estimated
  Pose T_odom_base = Pose::Identity();   ///< by odometry
  Matrix6 covariance = Matrix6::Zero();  ///< of T_map_base, see PoseBelief, along the axes of map

  /// Returns the pose of odom in map.
  Pose T_map_odom() const { return T_map_base * T_odom_base.inverse(Eigen::Isometry); }
};

/// The state of an estimate, to be reported.
struct EstimateStatus {
  std::size_t lines = 0;                    ///< with a pose
  bool is_lost = false;                     ///< see TrajectoryEstimate::is_lost()
  std::size_t decisions = 0;                ///< that were taken
  std::optional<Decision> latest_decision;  ///< nothing before the first
  double noise_scale = 0.0;                 ///< see TrajectoryEstimate::noise_scale()
  std::size_t windows = 0;                  ///< that were adjusted
  double window_s = 0.0;                    ///< computing time of the last window
  double longest_window_s = 0.0;            ///< computing time of the window that took longest
  double adjustment_s = 0.0;                ///< computing time of the last whole adjustment
  std::size_t base_scans = 0;               ///< of the base laser that were matched
};

/// An estimate of the trajectory with the observations that it reads. Both grow line by line.
class LiveEstimate {
 public:
  /// Starts without lines. Throws std::invalid_argument as Modeler does.
  LiveEstimate(const ModelerConfig& config, const EstimateConfig& estimate,
               bool with_base_laser = false);
  LiveEstimate(const LiveEstimate&) = delete;  // its parts refer to each other
  LiveEstimate& operator=(const LiveEstimate&) = delete;

  /// Adds a scan of a level laser on the base, which refines the odometry of lines that are added
  /// later. Returns why it was refused; an empty text if it was not.
  std::string add_base_scan(const ReadyLine& scan);

  /// Adds a line, posed by odometry: T_map_base of its poses is T_odom_base.
  LineOutcome add(const ReadyLine& line);

  /// Adjusts the whole trajectory. Lines may follow.
  void finish();

  /// Returns true if poses of older lines have changed since the last call.
  bool take_is_revised() { return std::exchange(is_revised_, false); }

  /// Returns the pose of the base in map for each line. Takes time in proportion to their number.
  std::vector<StampedPose> trajectory() const { return estimate_.trajectory(); }

  /// Returns the pose at the newest line. There must be one with a pose.
  PoseOfNow now() const;

  /// Returns the stamp of the newest line with a pose; zero before the first.
  Time newest() const;

  /// Returns all decisions in their order.
  const std::vector<Decision>& decisions() const { return estimate_.decisions(); }
  /// Returns the state.
  EstimateStatus status() const;

 private:
  const TrackedPoses& recorded() const { return modeler_.observations().trajectory().recorded(); }

  Modeler modeler_;
  LevelOdometry base_laser_{LevelOdometryConfig()};
  TrajectoryEstimate estimate_;
  std::optional<Eigen::Matrix3d> R_map_start_;  ///< `start` is the base at the first line
  bool is_revised_ = false;
  std::size_t windows_ = 0;
  double window_s_ = 0.0, longest_window_s_ = 0.0, adjustment_s_ = 0.0;
};

}  // namespace ribbon_mapper::slam
