// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/self_closure.hpp"

#include <algorithm>

#include "eval/experiment/sim_conversion.hpp"
#include "modeler/program/stopwatch.hpp"

namespace ribbon_mapper::eval {

void SelfClosure::update(const sim::Tour& tour, Time now) {
  if (with_base_laser_) take_base_scans(tour, now);
  const double seconds = cpu_seconds_of([&] { estimate_.update(); });
  updates_s_ += seconds;
  longest_update_s_ = std::max(longest_update_s_, seconds);
  if (estimate_.size() == 0) return;
  const auto [stamp, T_odom_base] = estimate_.newest_pose();
  if (!live_.empty() && live_.back().stamp == stamp) return;
  live_.push_back({stamp, tour.T_map_odom_at_start() * T_odom_base});
}

/// Takes the scans up to the first one that begins after `now`, which is all that a line needs.
void SelfClosure::take_base_scans(const sim::Tour& tour, Time now) {
  for (; base_lines_ < tour.base_line_count(); ++base_lines_) {
    const Time stamp = tour.base_scan_stamp(base_lines_);
    if (newest_base_scan_ > now) return;
    newest_base_scan_ = stamp;
    if (!base_laser_.is_due(stamp, tour.T_odom_base(stamp))) continue;  // its rays are most work
    const LaserBeams beams = beams_of(tour.base_scan(base_lines_));
    const LinePoses poses = base_laser_poses(tour, beams);
    base_laser_s_ += cpu_seconds_of([&] { base_laser_.add_scan(beams, poses); });
  }
}

std::vector<StampedPose> SelfClosure::finish(const sim::Tour& tour) {
  finish_s_ = cpu_seconds_of([&] { estimate_.finish(); });
  const Pose T_map_odom = tour.T_map_odom_at_start();
  std::vector<StampedPose> poses = estimate_.trajectory();
  for (StampedPose& pose : poses) pose.T_map_base = T_map_odom * pose.T_map_base;
  covariances_s_ = cpu_seconds_of([&] { covariances_ = estimate_.covariances(); });
  for (Matrix6& covariance : covariances_) {
    covariance = in_other_axes(covariance, T_map_odom.linear());
  }
  return poses;
}

EstimateSummary SelfClosure::summary(const std::vector<StampedPose>& estimate,
                                     const sim::Tour& tour) const {
  const std::vector<StampedPose> truth = true_poses(tour, estimate);
  return {
      trajectory_error(estimate, truth),
      EstimateReport{trajectory_error(live_, true_poses(tour, live_)), precision_of(covariances_),
                     planar_nees(estimate, covariances_, truth), estimate_.noise_scale(),
                     updates_s_, longest_update_s_, finish_s_, covariances_s_,
                     slam::texts_of(estimate_.decisions(), estimate.front().stamp)}};
}

}  // namespace ribbon_mapper::eval
