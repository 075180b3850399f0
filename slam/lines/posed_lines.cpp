// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/posed_lines.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

namespace ribbon_mapper::slam {
namespace {

/// Returns the covariance of the weighted mean of two independent estimates; the second may be
/// certain.
Eigen::Matrix3d fused(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Matrix3d both = a - a * (a + b).ldlt().solve(a);
  // Far below any sensor, so that beliefs stay regular.
  return 0.5 * (both + both.transpose()) + 1e-10 * Eigen::Matrix3d::Identity();
}

}  // namespace

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

/// Keeps the source's poses of some lines, and the covariances of the steps between these.
void PosedLines::keep_steps(const std::vector<std::uint32_t>& kept) {
  std::vector<Eigen::Matrix3f> covariances;
  covariances.reserve(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    covariances.push_back(i == 0 ? Eigen::Matrix3f::Zero()
                                 : covariance_between(kept[i - 1], kept[i]));
  }
  source_covariances_ = std::move(covariances);
  T_odom_base_.keep(kept);
}

/// Returns the covariance by the source of the way from one line to another. As for the recorded
/// odometry, the turn of a step does not lever those behind it: they are short.
Eigen::Matrix3f PosedLines::covariance_between(std::uint32_t from, std::uint32_t to) const {
  const double yaw_rad = yaw_of(T_odom_base(from));
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::uint32_t line = from + 1; line <= to; ++line) {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    R.topLeftCorner<2, 2>() =
        Eigen::Rotation2Dd(yaw_of(T_odom_base(line - 1)) - yaw_rad).toRotationMatrix();
    sum += R * source_covariances_[line].cast<double>() * R.transpose();
  }
  return sum.cast<float>();
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

std::uint32_t PosedLines::slip_length(std::uint32_t line) const {
  if (!is_slip(line)) return 0;
  std::uint32_t first = line, last = line;
  while (first > 0 && is_slip(first - 1)) --first;
  while (is_slip(last + 1)) ++last;
  return last + 1 - first;
}

void PosedLines::add_next() {
  const std::uint32_t line = size();
  stamps_.push_back(observations_->trajectory().recorded().stamps()[line]);
  T_start_base_.push_back(Pose::Identity());
  if (odometry_ != nullptr) {
    T_odom_base_.push_back(odometry_->T_odom_base(stamps_.back(), recorded_T_odom_base(line)));
    source_covariances_.emplace_back(Eigen::Matrix3f::Zero());
    if (line > 0) {
      source_covariances_.back() =
          odometry_->step_covariance(stamps_[line - 1], stamps_[line], step(line)).cast<float>();
    }
  }
  first_ribbons_.push_back(end_of_line(line));
}

Pose PosedLines::step(std::size_t line) const {
  if (line == 0) return Pose::Identity();
  return T_odom_base(line - 1).inverse(Eigen::Isometry) * T_odom_base(line);
}

Pose PosedLines::recorded_step(std::size_t line) const {
  if (line == 0) return Pose::Identity();
  return recorded_T_odom_base(line - 1).inverse(Eigen::Isometry) * recorded_T_odom_base(line);
}

Matrix6 PosedLines::fused_covariance(std::size_t line, const OdometryNoise& noise) const {
  const Vector6 variances = noise.variances(step(line));
  const Eigen::Vector3d recorded(variances[0], variances[1], variances[5]);
  const Eigen::Matrix3d planar = fused(recorded.asDiagonal(), source_covariance(line));
  Matrix6 covariance = variances.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) covariance(kInPlane[i], kInPlane[j]) = planar(i, j);
  }
  return covariance;
}

PoseBelief PosedLines::after_step_to(std::size_t line, const PoseBelief& before,
                                     const OdometryNoise& noise) const {
  if (has_source()) return after_step(before, step(line), fused_covariance(line, noise));
  return after_step(before, step(line), noise.variances(step(line)));
}

std::vector<PlaneObservation> PosedLines::measured(std::size_t line, const OdometryNoise& noise,
                                                   const RangeNoise& ranges) const {
  const Vector6 variances = noise.variances(step(line));
  std::vector<PlaneObservation> result;
  result.reserve(first_ribbons_[line + 1] - first_ribbons_[line]);
  for (std::uint32_t i = first_ribbons_[line]; i < first_ribbons_[line + 1]; ++i) {
    result.emplace_back(ribbon(i), ranges, variances);
  }
  return result;
}

}  // namespace ribbon_mapper::slam
