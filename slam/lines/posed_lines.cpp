// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/posed_lines.hpp"

#include <algorithm>

namespace ribbon_mapper::slam {

bool PosedLines::keep_in_step() {
  const std::vector<Ribbon>& ribbons = observations_->ribbons();
  const bool is_thinned = ribbons.size() < ribbons_seen_;
  ribbons_seen_ = ribbons.size();
  if (!is_thinned) return false;
  const std::vector<Time>& stamps = observations_->trajectory().recorded().stamps();
  std::vector<std::uint32_t> kept;
  for (std::uint32_t line = 0; line < size(); ++line) {
    if (std::binary_search(stamps.begin(), stamps.end(), stamps_[line])) kept.push_back(line);
  }
  T_start_base_.keep(kept);
  if (odometry_ != nullptr) keep_steps(kept);
  std::set<std::uint32_t> slips;  // the step to the next line that is left holds the wrong one
  for (const std::uint32_t slip : slips_) {
    slips.insert(static_cast<std::uint32_t>(std::lower_bound(kept.begin(), kept.end(), slip) -
                                            kept.begin()));
  }
  slips_ = std::move(slips);
  stamps_.assign(stamps.begin(), stamps.begin() + static_cast<std::ptrdiff_t>(kept.size()));
  first_ribbons_.assign(1, 0);
  for (std::uint32_t line = 0; line < size(); ++line) first_ribbons_.push_back(end_of_line(line));
  return true;
}

/// Keeps the source's poses of some lines. A step over others is bare if one of theirs was.
void PosedLines::keep_steps(const std::vector<std::uint32_t>& kept) {
  T_odom_base_.keep(kept);
  std::vector<bool> is_bare;
  std::uint32_t line = 0;
  for (const std::uint32_t end : kept) {
    bool is_one_bare = false;
    for (; line <= end; ++line) is_one_bare = is_one_bare || is_bare_[line];
    is_bare.push_back(is_one_bare);
  }
  is_bare_ = std::move(is_bare);
}

std::uint32_t PosedLines::end_of_line(std::uint32_t line) const {
  const std::vector<Ribbon>& ribbons = observations_->ribbons();
  std::uint32_t end = first_ribbons_.back();
  while (end < ribbons.size() && ribbons[end].pose == line) ++end;
  return end;
}

void PosedLines::set_slip(std::uint32_t line, bool is_slip) {
  if (is_slip)
    slips_.insert(line);
  else
    slips_.erase(line);
}

void PosedLines::add_next() {
  const std::uint32_t line = size();
  stamps_.push_back(observations_->trajectory().recorded().stamps()[line]);
  T_start_base_.push_back(Pose::Identity());
  if (odometry_ != nullptr) {
    const RefinedPose pose = odometry_->refined(stamps_.back(), recorded_T_odom_base(line));
    T_odom_base_.push_back(pose.T_odom_base);
    is_bare_.push_back(!pose.is_refined);
  }
  first_ribbons_.push_back(end_of_line(line));
}

Pose PosedLines::step(std::size_t line) const {
  if (line == 0) return Pose::Identity();
  return T_odom_base(line - 1).inverse(Eigen::Isometry) * T_odom_base(line);
}

std::vector<PlaneObservation> PosedLines::measured(std::size_t line, const OdometryNoise& noise,
                                                   const RangeNoise& ranges) const {
  const Vector6 motion = noise_of(line, noise).variances_within_line(step(line));
  std::vector<PlaneObservation> result;
  result.reserve(first_ribbons_[line + 1] - first_ribbons_[line]);
  for (std::uint32_t i = first_ribbons_[line]; i < first_ribbons_[line + 1]; ++i) {
    result.emplace_back(ribbon(i), ranges, motion);
  }
  return result;
}

}  // namespace ribbon_mapper::slam
