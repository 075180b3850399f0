// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/trajectory_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"
#include "modeler/registration/pose_belief.hpp"

namespace ribbon_mapper::eval {
namespace {

Eigen::Matrix3Xd positions_of(const std::vector<StampedPose>& trajectory) {
  Eigen::Matrix3Xd positions(3, trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = trajectory[i].T_map_base.translation();
  }
  return positions;
}

}  // namespace

TrajectoryError trajectory_error(const std::vector<StampedPose>& estimate,
                                 const std::vector<StampedPose>& truth) {
  if (estimate.empty() || estimate.size() != truth.size()) {
    throw std::invalid_argument("trajectory error: two trajectories of the same poses are needed");
  }
  const auto count = static_cast<double>(estimate.size());
  TrajectoryError error;
  double square_deg = 0.0;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const Pose difference = truth[i].T_map_base.inverse(Eigen::Isometry) * estimate[i].T_map_base;
    error.largest_m = std::max(error.largest_m, difference.translation().norm());
    square_deg += square(to_degrees(angle_of(difference)));
  }
  const Eigen::Matrix3Xd from = positions_of(estimate), to = positions_of(truth);
  const Pose aligned(Eigen::umeyama(from, to, false));
  error.rmse_m = std::sqrt((from - to).squaredNorm() / count);
  error.aligned_rmse_m = std::sqrt((aligned * from - to).squaredNorm() / count);
  error.rmse_deg = std::sqrt(square_deg / count);
  return error;
}

double planar_nees(std::vector<StampedPose> estimate, const std::vector<Matrix6>& covariances,
                   const std::vector<StampedPose>& truth) {
  if (estimate.size() < 2 || estimate.size() != truth.size() ||
      estimate.size() != covariances.size()) {
    throw std::invalid_argument("NEES: two or more poses with their covariances are needed");
  }
  const Pose T_truth_estimate =
      truth.front().T_map_base * estimate.front().T_map_base.inverse(Eigen::Isometry);
  double sum = 0.0;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    sum += mean_square_sigmas({T_truth_estimate * estimate[i].T_map_base, covariances[i]},
                              truth[i].T_map_base, kInPlane);
  }
  return sum / static_cast<double>(estimate.size() - 1);
}

}  // namespace ribbon_mapper::eval
