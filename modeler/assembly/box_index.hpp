// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <unsupported/Eigen/BVH>
#include <vector>

namespace ribbon_mapper {

/// Finds boxes near another box, in a time that hardly depends on how many there are.
class BoxIndex {
 public:
  /// Creates an index of these boxes. Empty ones are never near.
  explicit BoxIndex(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// Returns the ascending indices of the boxes within `reach_m` of a box along each axis.
  std::vector<std::size_t> near(const Eigen::AlignedBox3d& box, double reach_m) const;

 private:
  /// A box with its index. Eigen's tree finds its volume by bounding_box().
  struct Entry {
    std::size_t index;
    Eigen::AlignedBox3d box;
    friend const Eigen::AlignedBox3d& bounding_box(const Entry& entry) { return entry.box; }
  };
  struct Query;

  Eigen::KdBVH<double, 3, Entry> tree_;
};

}  // namespace ribbon_mapper
