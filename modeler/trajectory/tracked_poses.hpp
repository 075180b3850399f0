// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/geometry/packed_poses.hpp"
#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// A pose as it was recorded: where localisation and odometry believed the base to be.
struct TrackedPose {
  StampedPose in_map;
  Pose T_odom_base = Pose::Identity();
};

/// Many of these, in order of time.
class TrackedPoses {
 public:
  void push_back(const TrackedPose& pose);
  /// Leaves out all but these, in order.
  void keep(const std::vector<std::uint32_t>& indices);

  std::size_t size() const { return stamps_.size(); }
  bool empty() const { return stamps_.empty(); }
  TrackedPose operator[](std::size_t index) const;
  const std::vector<Time>& stamps() const { return stamps_; }
  const PackedPoses& T_map_base() const { return T_map_base_; }
  const PackedPoses& T_odom_base() const { return T_odom_base_; }
  std::size_t memory_bytes() const;

 private:
  std::vector<Time> stamps_;
  PackedPoses T_map_base_, T_odom_base_;
};

}  // namespace ribbon_mapper
