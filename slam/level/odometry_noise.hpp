// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "slam/matching/planar_pose.hpp"

namespace ribbon_mapper::slam {

/// Settings for the noise of odometry.
struct PlanarOdometryNoiseConfig {
  double per_metre_m = 0.1;     ///< deviation of the position by way: a skid-steered robot's
  double at_rest_m = 0.005;     ///< and of each step
  double per_radian_rad = 0.1;  ///< deviation of the heading by turning
  double per_metre_rad = 0.02;  ///< by way
  double at_rest_rad = 0.003;   ///< and of each step
  double least_scale = 0.1;     ///< odometry is never trusted more than ten times the above
  double most_scale = 3.0;      ///< nor less than a third of it
  double memory = 300.0;        ///< steps; a log's odometry is one robot's on one floor
};

/// Learns how exact the odometry of a robot is from the errors of its predictions.
class PlanarOdometryNoise {
 public:
  /// Begins with the configured noise.
  explicit PlanarOdometryNoise(const PlanarOdometryNoiseConfig& config) : config_(config) {}

  /// Returns the information of x, y and yaw after a step of odometry.
  Eigen::Matrix3d information(const PlanarPose& step) const;

  /// Takes in how far a pose that is well observed lies from its prediction, in the frame of the
  /// prediction.
  void learn(const PlanarPose& step, const PlanarPose& error);

  /// Returns the deviation of positions, as a multiple of the configured one.
  double scale_xy() const;
  /// Returns the deviation of headings, as a multiple of the configured one.
  double scale_yaw() const;

 private:
  Eigen::Vector3d deviations(const PlanarPose& step) const;

  PlanarOdometryNoiseConfig config_;
  double square_xy_ = 1.0, square_yaw_ = 1.0;  ///< means of squared errors
  double steps_ = 20.0;                        ///< weight of the means; they begin with some
};

}  // namespace ribbon_mapper::slam
