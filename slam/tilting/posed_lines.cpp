// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/posed_lines.hpp"

namespace ribbon_mapper::slam {
namespace {

// The average time of a beam from the middle of its line, in intervals between lines.
constexpr double kMeanBeamOffset = 0.25;

}  // namespace

void PosedLines::add(Time stamp, const Pose& T_odom_base, const Pose& T_start_base) {
  stamps_.push_back(stamp);
  T_odom_base_.push_back(T_odom_base);
  T_start_base_.push_back(T_start_base);
  std::uint32_t end = first_ribbons_.back();
  while (end < ribbons_->size() && (*ribbons_)[end].pose + 1 == stamps_.size()) ++end;
  first_ribbons_.push_back(end);
}

Pose PosedLines::step(std::size_t line) const {
  if (line == 0) return Pose::Identity();
  return T_odom_base_[line - 1].inverse(Eigen::Isometry) * T_odom_base_[line];
}

std::vector<PlaneObservation> PosedLines::observations(std::size_t line, const OdometryNoise& noise,
                                                       const RangeNoise& ranges) const {
  const Vector6 motion = kMeanBeamOffset * noise.variances(step(line));
  std::vector<PlaneObservation> observations;
  observations.reserve(first_ribbons_[line + 1] - first_ribbons_[line]);
  for (std::uint32_t i = first_ribbons_[line]; i < first_ribbons_[line + 1]; ++i) {
    observations.emplace_back(ribbon(i), ranges, motion);
  }
  return observations;
}

}  // namespace ribbon_mapper::slam
