// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/trajectory_estimate.hpp"

#include <algorithm>

#include "modeler/geometry/square.hpp"
#include "slam/tilting/line_adjustment.hpp"

namespace ribbon_mapper::slam {
namespace {

// The robot hardly moves within so many lines (half a second at 40 Hz): one stands for all.
constexpr std::uint32_t kLinesOfPlace = 20;

}  // namespace

TrajectoryEstimate::TrajectoryEstimate(const Observations& observations,
                                       const EstimateSettings& settings)
    : settings_(settings),
      noise_scale_(settings.estimate.first_noise_scale, settings.estimate.first_spatial_scale),
      noise_(noise_scale_.noise()),
      lines_(observations),
      tracker_(settings) {}

bool TrajectoryEstimate::update() {
  if (lines_.keep_in_step()) settled_ = 0;
  bool is_revised = false;
  while (lines_.has_next()) {
    lines_.add_next();
    const std::uint32_t line = lines_.size() - 1;
    if (line == 0) T_odom_start_ = lines_.T_odom_base(0), last_window_ = lines_.stamp(0);
    tracker_.track(lines_, line, noise_);
    if (to_seconds(lines_.stamp(line) - last_window_) < settings_.estimate.window_step_s) continue;
    last_window_ = lines_.stamp(line);
    adjust_window();
    is_revised = true;
  }
  return is_revised;
}

std::uint32_t TrajectoryEstimate::first_of_window() const {
  const std::uint32_t last = lines_.size() - 1;
  std::uint32_t first = last;
  while (first > 1 && lines_.seconds_between(first - 1, last) < settings_.estimate.window_s) {
    --first;
  }
  return first;
}

std::vector<std::uint32_t> TrajectoryEstimate::context_of(std::uint32_t first) const {
  std::vector<Eigen::Vector3d> places;
  for (std::uint32_t i = first; i < lines_.size(); i += kLinesOfPlace) {
    places.push_back(lines_.T_start_base(i).translation());
  }
  const auto is_near = [&](const Eigen::Vector3d& place) {
    return std::any_of(places.begin(), places.end(), [&](const Eigen::Vector3d& other) {
      return (place - other).squaredNorm() < square(settings_.estimate.context_radius_m);
    });
  };
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < first; i += kLinesOfPlace) {
    if (!is_near(lines_.T_start_base(i).translation())) continue;
    for (std::uint32_t k = i; k < std::min(first, i + kLinesOfPlace); ++k) near.push_back(k);
  }
  const auto most = static_cast<std::size_t>(settings_.estimate.max_context_lines);
  if (near.size() <= most) return near;
  for (std::size_t i = 0; i < most; ++i) near[i] = near[i * near.size() / most];
  near.resize(most);
  return near;
}

void TrajectoryEstimate::learn_noise(std::uint32_t first_of_window) {
  if (first_of_window <= settled_ + 1) return;
  noise_scale_.learn(lines_, settled_, first_of_window);
  noise_ = noise_scale_.noise();
  settled_ = first_of_window - 1;
}

void TrajectoryEstimate::adjust_window() {
  const std::uint32_t first = first_of_window();
  AdjustedLines window{first, lines_.size(), context_of(first)};
  adjust_lines(lines_, window, noise_, settings_);
  learn_noise(first);
  restart_tracker(std::move(window.context), first);
}

/// Lets the tracker go on with the planes of a window that begins at `first`, and of its context.
void TrajectoryEstimate::restart_tracker(std::vector<std::uint32_t> context, std::uint32_t first) {
  for (std::uint32_t i = first; i < lines_.size(); ++i) context.push_back(i);
  tracker_.restart(KnownPlanes(lines_, context, settings_.estimate.gates.back(), settings_),
                   {lines_.T_start_base(lines_.size() - 1), tracker_.belief().covariance});
}

void TrajectoryEstimate::finish() {
  if (lines_.size() < 2) return;
  adjust_lines(lines_, {1, lines_.size(), {0}}, noise_, settings_);
  const std::uint32_t first = first_of_window();
  restart_tracker(context_of(first), first);
}

std::vector<StampedPose> TrajectoryEstimate::trajectory() const {
  std::vector<StampedPose> poses;
  poses.reserve(lines_.size());
  for (std::uint32_t i = 0; i < lines_.size(); ++i) {
    poses.push_back({lines_.stamp(i), T_odom_start_ * lines_.T_start_base(i)});
  }
  return poses;
}

std::vector<Matrix6> TrajectoryEstimate::covariances() const {
  std::vector<Matrix6> covariances(std::min(lines_.size(), 1U), Matrix6::Zero());
  for (const Matrix6& c : line_covariances(lines_, {1, lines_.size(), {0}}, noise_, settings_)) {
    covariances.push_back(in_other_axes(c, T_odom_start_.linear()));
  }
  return covariances;
}

}  // namespace ribbon_mapper::slam
