// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/trajectory/trajectory.hpp"

#include <stdexcept>
#include <utility>

namespace ribbon_mapper {

Trajectory::Trajectory(const TrajectoryConfig& config, Parts parts)
    : config_(config),
      recorded_(std::make_shared<TrackedPoses>(std::move(parts.recorded))),
      T_map_base_(std::move(parts.now)),
      is_as_corrected_(parts.is_as_corrected) {
  if (parts.correction) {
    correction_ = std::make_shared<const Correction>(std::move(*parts.correction));
  }
}

/// Returns the recorded poses to be changed. Copies them if another trajectory has them, too.
TrackedPoses& Trajectory::own_recorded() {
  if (recorded_.use_count() > 1) recorded_ = std::make_shared<TrackedPoses>(*recorded_);
  return *recorded_;
}

void Trajectory::reserve_one_more() {
  own_recorded().reserve_one_more();
  if (correction_) T_map_base_.reserve_one_more();
}

void Trajectory::add(const TrackedPose& recorded) {
  reserve_one_more();
  recorded_->push_back(recorded);
  if (!correction_) return;
  T_map_base_.push_back(config_.poses_follow ? recorded.in_map.T_map_base
                                             : correction_->corrected(recorded));
}

void Trajectory::correct(const std::vector<StampedPose>& corrected) {
  if (recorded_->empty()) throw std::invalid_argument("there is no model to correct yet");
  auto correction = std::make_shared<const Correction>(
      *recorded_, corrected, is_as_corrected_ ? correction_.get() : nullptr);
  if (T_map_base_.empty()) T_map_base_ = recorded_->T_map_base();
  for (std::size_t i = correction->unchanged(*recorded_); i < size(); ++i) {
    T_map_base_.set(i, correction->corrected((*recorded_)[i]));
  }
  correction_ = std::move(correction);
  is_as_corrected_ = true;
}

void Trajectory::refine(const std::vector<StampedPose>& poses) {
  for (std::size_t i = 0; i < size(); ++i) T_map_base_.set(i, poses[i].T_map_base);
  is_as_corrected_ = false;
}

void Trajectory::keep(const std::vector<std::uint32_t>& indices) {
  own_recorded().keep(indices);
  if (!T_map_base_.empty()) T_map_base_.keep(indices);
  is_as_corrected_ = false;
}

Pose Trajectory::T_map_base(std::size_t index) const { return poses_now()[index]; }

std::size_t Trajectory::common_with(const Trajectory& other) const {
  return poses_now().common_with(other.poses_now());
}

std::vector<StampedPose> Trajectory::poses() const {
  std::vector<StampedPose> poses;
  poses.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) poses.push_back({recorded_->stamps()[i], T_map_base(i)});
  return poses;
}

std::size_t Trajectory::memory_bytes() const {
  return recorded_->memory_bytes() + T_map_base_.memory_bytes();
}

}  // namespace ribbon_mapper
