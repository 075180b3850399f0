// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/geometry/packed_poses.hpp"
#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// The pose of the base in map, with its pose in odom at the same time.
struct TrackedPose {
  StampedPose in_map;                   ///< stamp and pose of the base in map
  Pose T_odom_base = Pose::Identity();  ///< pose of the base in odom at that stamp
};

/// A sequence of tracked poses in the order of their stamps, packed.
class TrackedPoses {
 public:
  /// Makes room for `count` poses in total.
  void reserve(std::size_t count);
  /// Makes room for one more pose: the next push_back() cannot fail.
  void reserve_one_more();
  /// Appends a pose. Its stamp must be later than that of the last one.
  void push_back(const TrackedPose& pose);
  /// Appends a pose as it is stored, bit by bit. Its stamp must be later than that of the last one.
  void push_back(Time stamp, const PackedPoses::Numbers& T_map_base,
                 const PackedPoses::Numbers& T_odom_base);
  /// Appends the first `count` poses of `others`, which must be later than the last one.
  void append_first(std::size_t count, const TrackedPoses& others);
  /// Returns true if there is a pose at `index` and it has this stamp and pose in map, bit by bit.
  bool holds(std::size_t index, const StampedPose& in_map) const;
  /// Keeps only the poses at these ascending indices.
  void keep(const std::vector<std::uint32_t>& indices);

  /// Returns the number of poses.
  std::size_t size() const { return stamps_.size(); }
  /// Returns true if there are no poses.
  bool empty() const { return stamps_.empty(); }
  /// Returns the pose at `index`.
  TrackedPose operator[](std::size_t index) const;
  /// Returns the stamps, strictly ascending.
  const std::vector<Time>& stamps() const { return stamps_; }
  /// Returns the poses of the base in map.
  const PackedPoses& T_map_base() const { return T_map_base_; }
  /// Returns the poses of the base in odom.
  const PackedPoses& T_odom_base() const { return T_odom_base_; }
  /// Returns the memory in use.
  std::size_t memory_bytes() const;

 private:
  std::vector<Time> stamps_;
  PackedPoses T_map_base_, T_odom_base_;
};

}  // namespace ribbon_mapper
