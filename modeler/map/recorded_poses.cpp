// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/recorded_poses.hpp"

#include "modeler/geometry/sparing_vector.hpp"

namespace ribbon_mapper {

void RecordedPoses::push_back(const RecordedPose& pose) {
  grow_sparingly(stamps_);
  stamps_.push_back(pose.in_map.stamp);
  T_map_base_.push_back(pose.in_map.T_map_base);
  T_odom_base_.push_back(pose.T_odom_base);
}

void RecordedPoses::keep(const std::vector<std::uint32_t>& indices) {
  keep_only(indices, stamps_);
  T_map_base_.keep(indices);
  T_odom_base_.keep(indices);
}

RecordedPose RecordedPoses::operator[](std::size_t index) const {
  return {{stamps_[index], T_map_base_[index]}, T_odom_base_[index]};
}

std::size_t RecordedPoses::memory_bytes() const {
  return stamps_.capacity() * sizeof(Time) + T_map_base_.memory_bytes() +
         T_odom_base_.memory_bytes();
}

}  // namespace ribbon_mapper
