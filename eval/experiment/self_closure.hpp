// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "eval/results/summary.hpp"
#include "modeler/modeler.hpp"
#include "sim/tour/tour.hpp"
#include "slam/tilting/trajectory_estimate.hpp"

namespace ribbon_mapper::eval {

/// Corrects a model by an estimate from its odometry and ribbons. The truth only places the
/// odometry's frame in map, and scores.
class SelfClosure {
 public:
  /// Starts an estimate beside a modeler, which must outlive this.
  SelfClosure(const Modeler& modeler, const ModelerConfig& config)
      : estimate_(modeler.observations(), slam::estimate_settings(config)) {}

  /// Takes the lines that the modeler has gained.
  void update();

  /// Ends the estimate, and computes its covariances. Returns it in map.
  std::vector<StampedPose> finish(const sim::Tour& tour);

  /// Returns the covariances of what finish() returned, along the axes of map.
  const std::vector<Matrix6>& covariances() const { return covariances_; }

  /// Returns the figures of an estimate that is finished. `estimate` is what finish() returned.
  EstimateSummary summary(const std::vector<StampedPose>& estimate,
                          const std::vector<StampedPose>& truth) const;

 private:
  slam::TrajectoryEstimate estimate_;
  std::vector<Matrix6> covariances_;
  double updates_s_ = 0.0, longest_update_s_ = 0.0, finish_s_ = 0.0, covariances_s_ = 0.0;
};

}  // namespace ribbon_mapper::eval
