// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Poses as quaternion and position: 56 bytes in the place of 128.
class PackedPoses {
 public:
  void push_back(const Pose& pose);
  void set(std::size_t index, const Pose& pose) { poses_[index] = packed(pose); }
  /// Leaves out all but these, in order.
  void keep(const std::vector<std::uint32_t>& indices);
  Pose operator[](std::size_t index) const;

  std::size_t size() const { return poses_.size(); }
  bool empty() const { return poses_.empty(); }
  std::size_t memory_bytes() const { return poses_.capacity() * sizeof(Packed); }

 private:
  using Packed = std::array<double, 7>;  // x, y, z, w of the rotation, then the translation
  static Packed packed(const Pose& pose);

  std::vector<Packed> poses_;
};

}  // namespace ribbon_mapper
