// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/trajectory.hpp"

#include <stdexcept>

#include "modeler/geometry/sparing_vector.hpp"

namespace ribbon_mapper {

void Trajectory::add(const RecordedPose& recorded) {
  grow_sparingly(stamps_);
  stamps_.push_back(recorded.in_map.stamp);
  T_map_base_recorded_.push_back(recorded.in_map.T_map_base);
  T_odom_base_recorded_.push_back(recorded.T_odom_base);
  if (!correction_) return;
  T_map_base_.push_back(config_.poses_follow ? recorded.in_map.T_map_base
                                             : correction_->corrected(recorded));
}

void Trajectory::correct(const std::vector<StampedPose>& corrected) {
  if (stamps_.empty()) throw std::invalid_argument("there is no model to correct yet");
  const std::vector<RecordedPose> as_recorded = recorded();
  correction_.emplace(as_recorded, corrected);
  if (T_map_base_.empty()) T_map_base_ = T_map_base_recorded_;
  for (std::size_t i = 0; i < size(); ++i) {
    T_map_base_.set(i, correction_->corrected(as_recorded[i]));
  }
}

void Trajectory::refine(const std::vector<StampedPose>& poses) {
  for (std::size_t i = 0; i < size(); ++i) T_map_base_.set(i, poses[i].T_map_base);
}

void Trajectory::keep(const std::vector<std::uint32_t>& indices) {
  keep_only(indices, stamps_);
  T_map_base_recorded_.keep(indices);
  T_odom_base_recorded_.keep(indices);
  if (!T_map_base_.empty()) T_map_base_.keep(indices);
}

Pose Trajectory::T_map_base(std::size_t index) const {
  return T_map_base_.empty() ? T_map_base_recorded_[index] : T_map_base_[index];
}

std::vector<StampedPose> Trajectory::poses() const {
  std::vector<StampedPose> poses;
  poses.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) poses.push_back({stamps_[i], T_map_base(i)});
  return poses;
}

RecordedPose Trajectory::recorded(std::size_t index) const {
  return {{stamps_[index], T_map_base_recorded_[index]}, T_odom_base_recorded_[index]};
}

std::vector<RecordedPose> Trajectory::recorded() const {
  std::vector<RecordedPose> poses;
  poses.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) poses.push_back(recorded(i));
  return poses;
}

std::size_t Trajectory::memory_bytes() const {
  return stamps_.capacity() * sizeof(Time) + T_map_base_recorded_.memory_bytes() +
         T_odom_base_recorded_.memory_bytes() + T_map_base_.memory_bytes();
}

}  // namespace ribbon_mapper
