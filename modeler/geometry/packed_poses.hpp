// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// A vector of poses stored as quaternion and position: 56 bytes per pose instead of 128.
class PackedPoses {
 public:
  /// The rotation as a unit quaternion x, y, z, w, then the translation x, y, z [m].
  using Numbers = std::array<double, 7>;

  /// Makes room for `count` poses in total.
  void reserve(std::size_t count) { poses_.reserve(count); }
  /// Makes room for one more pose: the next push_back() cannot fail.
  void reserve_one_more();
  /// Appends a pose.
  void push_back(const Pose& pose);
  /// Appends a pose as numbers() has returned it, bit by bit.
  void push_back(const Numbers& numbers) { poses_.push_back(numbers); }
  /// Returns the numbers of the pose at `index`, bit by bit.
  const Numbers& numbers(std::size_t index) const { return poses_[index]; }
  /// Replaces the pose at `index`.
  void set(std::size_t index, const Pose& pose) { poses_[index] = packed(pose); }
  /// Appends the first `count` poses of `others`.
  void append_first(std::size_t count, const PackedPoses& others);
  /// Returns true if the pose at `index` is this one, bit by bit.
  bool holds(std::size_t index, const Pose& pose) const;
  /// Returns the number of the first poses that both have in common, bit by bit.
  std::size_t common_with(const PackedPoses& others) const;
  /// Removes all poses but those at these ascending indices.
  void keep(const std::vector<std::uint32_t>& indices);
  /// Unpacks the pose at `index`.
  Pose operator[](std::size_t index) const;

  /// Returns the number of poses.
  std::size_t size() const { return poses_.size(); }
  /// Returns true if there are no poses.
  bool empty() const { return poses_.empty(); }
  /// Returns the memory in use.
  std::size_t memory_bytes() const { return poses_.capacity() * sizeof(Numbers); }

 private:
  static Numbers packed(const Pose& pose);

  std::vector<Numbers> poses_;
};

}  // namespace ribbon_mapper
