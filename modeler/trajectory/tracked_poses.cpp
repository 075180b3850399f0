// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/trajectory/tracked_poses.hpp"

#include "modeler/geometry/vector_storage.hpp"

namespace ribbon_mapper {

void TrackedPoses::reserve(std::size_t count) {
  stamps_.reserve(count);
  T_map_base_.reserve(count);
  T_odom_base_.reserve(count);
}

void TrackedPoses::reserve_one_more() {
  ribbon_mapper::reserve_one_more(stamps_);
  T_map_base_.reserve_one_more();
  T_odom_base_.reserve_one_more();
}

void TrackedPoses::push_back(const TrackedPose& pose) {
  reserve_one_more();
  stamps_.push_back(pose.in_map.stamp);
  T_map_base_.push_back(pose.in_map.T_map_base);
  T_odom_base_.push_back(pose.T_odom_base);
}

void TrackedPoses::push_back(Time stamp, const PackedPoses::Numbers& T_map_base,
                             const PackedPoses::Numbers& T_odom_base) {
  reserve_one_more();
  stamps_.push_back(stamp);
  T_map_base_.push_back(T_map_base);
  T_odom_base_.push_back(T_odom_base);
}

void TrackedPoses::append_first(std::size_t count, const TrackedPoses& others) {
  const auto first = others.stamps_.begin();
  stamps_.insert(stamps_.end(), first, first + static_cast<std::ptrdiff_t>(count));
  T_map_base_.append_first(count, others.T_map_base_);
  T_odom_base_.append_first(count, others.T_odom_base_);
}

bool TrackedPoses::holds(std::size_t index, const StampedPose& in_map) const {
  return index < size() && stamps_[index] == in_map.stamp &&
         T_map_base_.holds(index, in_map.T_map_base);
}

void TrackedPoses::keep(const std::vector<std::uint32_t>& indices) {
  keep_indices(indices, stamps_);
  T_map_base_.keep(indices);
  T_odom_base_.keep(indices);
}

TrackedPose TrackedPoses::operator[](std::size_t index) const {
  return {{stamps_[index], T_map_base_[index]}, T_odom_base_[index]};
}

std::size_t TrackedPoses::memory_bytes() const {
  return stamps_.capacity() * sizeof(Time) + T_map_base_.memory_bytes() +
         T_odom_base_.memory_bytes();
}

}  // namespace ribbon_mapper
