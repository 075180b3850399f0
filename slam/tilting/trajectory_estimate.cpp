// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/trajectory_estimate.hpp"

#include "modeler/geometry/square.hpp"
#include "slam/tilting/line_adjustment.hpp"

namespace ribbon_mapper::slam {

TrajectoryEstimate::TrajectoryEstimate(const Observations& observations,
                                       const EstimateSettings& settings)
    : settings_(settings), noise_scale_(settings.estimate.first_noise_scale), lines_(observations.ribbons()), tracker_(settings) {
  noise_.planar_scale = noise_scale_.planar_scale();
  noise_.spatial_scale = 0.01;
}

bool TrajectoryEstimate::add_line(Time stamp, const Pose& T_odom_base) {
  if (lines_.size() == 0) T_odom_start_ = T_odom_base;
  lines_.add(stamp, T_odom_base, Pose::Identity());
  tracker_.track(lines_, lines_.size() - 1, noise_);
  const Time since = stamp - lines_.stamp(window_line_);
  if (to_seconds(since) < settings_.estimate.window_step_s) return false;
  adjust_window();
  window_line_ = lines_.size() - 1;
  return true;
}

std::vector<std::uint32_t> TrajectoryEstimate::context_of(std::uint32_t first) const {
  std::vector<Eigen::Vector3d> places;
  for (std::uint32_t i = first; i < lines_.size(); i += 20) places.push_back(lines_.pose(i).translation());
  std::vector<std::uint32_t> near;
  bool is_near = false;
  for (std::uint32_t i = 0; i < first; ++i) {
    if (i % 20 == 0) {
      is_near = false;
      const Eigen::Vector3d place = lines_.pose(i).translation();
      for (const auto& other : places) {
        is_near = is_near || (place - other).squaredNorm() < square(settings_.estimate.radius_m);
      }
    }
    if (is_near) near.push_back(i);
  }
  const auto most = static_cast<std::size_t>(settings_.estimate.max_context_lines);
  if (near.size() <= most) return near;
  std::vector<std::uint32_t> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(near[i * near.size() / most]);
  return some;
}

void TrajectoryEstimate::adjust_window() {
  const std::uint32_t end = lines_.size();
  std::uint32_t first = end - 1;
  while (first > 1 && to_seconds(lines_.stamp(end - 1) - lines_.stamp(first - 1)) <
                          settings_.estimate.window_s) {
    --first;
  }
  AdjustedLines which{first, end, context_of(first)};
  adjust_lines(lines_, which, settings_.estimate.window_gates, noise_, settings_);
  if (first > settled_ + 1) {
    noise_scale_.learn(lines_, settled_, first);
    noise_.planar_scale = noise_scale_.planar_scale();
    settled_ = first - 1;
  }
  for (std::uint32_t i = first; i < end; ++i) which.context.push_back(i);
  PoseBelief belief = tracker_.belief();
  belief.T_model_base = lines_.pose(end - 1);
  tracker_.restart(
      KnownPlanes(lines_, which.context, settings_.estimate.window_gates.back(), settings_), belief);
}

void TrajectoryEstimate::finish() {
  adjust_lines(lines_, {1, lines_.size(), {0}}, settings_.estimate.final_gates, noise_, settings_);
}

std::vector<StampedPose> TrajectoryEstimate::trajectory() const {
  std::vector<StampedPose> poses;
  for (std::uint32_t i = 0; i < lines_.size(); ++i) {
    poses.push_back({lines_.stamp(i), T_odom_start_ * lines_.pose(i)});
  }
  return poses;
}

}  // namespace ribbon_mapper::slam
