// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "eval/results/summary.hpp"
#include "modeler/modeler.hpp"
#include "sim/tour/tour.hpp"
#include "slam/base_laser/level_odometry.hpp"
#include "slam/tilting/trajectory_estimate.hpp"

namespace ribbon_mapper::eval {

/// Corrects a model by an estimate from its odometry and ribbons, and from the base laser if
/// wanted. The truth only places the odometry's frame in map, and scores.
class SelfClosure {
 public:
  /// Starts an estimate beside a modeler, which must outlive this.
  SelfClosure(const Modeler& modeler, const ModelerConfig& config, bool with_base_laser)
      : with_base_laser_(with_base_laser),
        estimate_(modeler.observations(), slam::estimate_settings(config),
                  with_base_laser ? &base_laser_ : nullptr) {}
  SelfClosure(const SelfClosure&) = delete;  // the estimate refers to the base laser
  SelfClosure& operator=(const SelfClosure&) = delete;

  /// Takes the lines that the modeler has gained, and the scans of the base laser up to `now`.
  void update(const sim::Tour& tour, Time now);

  /// Ends the estimate, and computes its covariances. Returns it in map.
  std::vector<StampedPose> finish(const sim::Tour& tour);

  /// Returns the covariances of what finish() returned, along the axes of map.
  const std::vector<Matrix6>& covariances() const { return covariances_; }

  /// Returns the poses in map that each line had when it was the newest one, as the node sends
  /// them.
  const std::vector<StampedPose>& live_trajectory() const { return live_; }

  /// Returns the figures of an estimate that is finished. `estimate` is what finish() returned.
  EstimateSummary summary(const std::vector<StampedPose>& estimate, const sim::Tour& tour) const;

 private:
  void take_base_scans(const sim::Tour& tour, Time now);

  bool with_base_laser_;
  slam::LevelOdometry base_laser_{slam::LevelOdometryConfig()};
  std::size_t base_lines_ = 0;  // taken
  Time newest_base_scan_{-1};   // stamp of the last of these
  slam::TrajectoryEstimate estimate_;
  std::vector<StampedPose> live_;
  std::vector<Matrix6> covariances_;
  double base_laser_s_ = 0.0, updates_s_ = 0.0, longest_update_s_ = 0.0, finish_s_ = 0.0,
         covariances_s_ = 0.0;
};

}  // namespace ribbon_mapper::eval
