// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace ribbon_mapper::sim {

/// A tree of axis-parallel boxes with four children a node, split by the surface area heuristic
/// (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).
struct BoxTree {
  static constexpr int kChildren = 4;
  using Floats = float __attribute__((vector_size(kChildren * sizeof(float))));

  /// The boxes of the four children, coordinate by coordinate for a test of all four at once. A
  /// child is a node (count 0) or `count` items from `first` on; an absent one has an empty box.
  struct Node {
    std::array<Floats, 3> low_m, high_m;
    std::array<std::int32_t, kChildren> first, count;
  };

  /// From the root to any leaf at most (poor splits are not made below half of that).
  static constexpr int kMaxLevels = 80;

  std::vector<Node> nodes;          ///< the root first
  std::vector<std::int32_t> items;  ///< indices into the boxes given, leaf by leaf

  /// Boxes are widened by `margin_m` and outwards to float.
  BoxTree(const std::vector<Eigen::AlignedBox3d>& boxes, double margin_m);
};

}  // namespace ribbon_mapper::sim
