// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/trajectory_estimate.hpp"

#include <algorithm>

#include "slam/lines/line_adjustment.hpp"

namespace ribbon_mapper::slam {

TrajectoryEstimate::TrajectoryEstimate(const Observations& observations,
                                       const EstimateSettings& settings,
                                       const OdometrySource* odometry)
    : settings_(settings),
      noise_scale_(settings.estimate.first_noise_scale, settings.estimate.first_spatial_scale),
      noise_(noise_scale_.noise()),
      lines_(observations, odometry),
      tracker_(settings),
      relocaliser_(settings) {}

bool TrajectoryEstimate::update() {
  if (lines_.keep_in_step()) settled_ = 0, tracked_.clear(), relocaliser_.forget_lines();
  bool is_revised = false;
  while (lines_.has_next()) {
    lines_.add_next();
    const std::uint32_t line = lines_.size() - 1;
    if (line == 0) T_odom_start_ = lines_.T_odom_base(0), last_window_ = lines_.stamp(0);
    tracker_.track(lines_, line, noise_);
    tracked_.push_back(tracker_.belief().covariance);
    if (to_seconds(lines_.stamp(line) - last_window_) < settings_.estimate.window_step_s) continue;
    last_window_ = lines_.stamp(line);
    adjust_window();
    is_revised = true;
  }
  return is_revised;
}

void TrajectoryEstimate::learn_noise(std::uint32_t first_of_window) {
  if (first_of_window <= settled_ + 1) return;
  noise_scale_.learn(lines_, settled_, first_of_window);
  noise_ = noise_scale_.noise();
  settled_ = first_of_window - 1;
}

void TrajectoryEstimate::adjust_window() {
  const std::uint32_t first = first_within(lines_, settings_.estimate.window_s);
  const std::size_t in_window = std::min<std::size_t>(lines_.size() - first, tracked_.size());
  tracked_.erase(tracked_.begin(), tracked_.end() - static_cast<std::ptrdiff_t>(in_window));
  AdjustedLines window{first, lines_.size(), context_before(first), tracked_};
  adjust_lines(lines_, window, noise_, settings_);
  if (relocaliser_.look(lines_, tracker_.known_share(), noise_)) {
    window.context = context_before(first);
    tracked_.clear();  // they are of other poses
  }
  learn_noise(first);
  restart_tracker(std::move(window.context), first);
}

std::vector<std::uint32_t> TrajectoryEstimate::context_before(std::uint32_t first) const {
  return context_of(lines_, {first, lines_.size()}, first, settings_.estimate);
}

/// Lets the tracker go on with the planes of a window that begins at `first`, and of its context.
void TrajectoryEstimate::restart_tracker(std::vector<std::uint32_t> context, std::uint32_t first) {
  for (std::uint32_t i = first; i < lines_.size(); ++i) context.push_back(i);
  tracker_.restart(KnownPlanes(lines_, context, settings_.estimate.gates.back(), settings_),
                   {lines_.T_start_base(lines_.size() - 1), tracker_.belief().covariance});
}

void TrajectoryEstimate::finish() {
  if (lines_.size() < 2) return;
  adjust_lines(lines_, {1, lines_.size(), {0}, {}}, noise_, settings_);
  const std::uint32_t first = first_within(lines_, settings_.estimate.window_s);
  restart_tracker(context_before(first), first);
}

std::vector<StampedPose> TrajectoryEstimate::trajectory() const {
  std::vector<StampedPose> poses;
  poses.reserve(lines_.size());
  for (std::uint32_t i = 0; i < lines_.size(); ++i) poses.push_back(pose(i));
  return poses;
}

std::vector<Matrix6> TrajectoryEstimate::covariances() const {
  std::vector<Matrix6> covariances(std::min(lines_.size(), 1U), Matrix6::Zero());
  for (const Matrix6& c :
       line_covariances(lines_, {1, lines_.size(), {0}, {}}, noise_, settings_)) {
    covariances.push_back(in_other_axes(c, T_odom_start_.linear()));
  }
  return covariances;
}

}  // namespace ribbon_mapper::slam
