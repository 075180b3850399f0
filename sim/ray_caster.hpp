// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "sim/tessellation.hpp"

namespace ribbon_mapper::sim {

struct Hit {
  double range_m = 0.0;
  int face = -1;  ///< index into World::faces()
};

/// First triangle along a ray, by the bounding volume hierarchy of Bullet. Both sides of a triangle
/// stop a ray. Bullet's own triangle test widens triangles by a share of their size, so that the
/// intersection is computed here (Moeller and Trumbore 1997).
class RayCaster {
 public:
  explicit RayCaster(const std::vector<Triangle>& triangles);
  ~RayCaster();

  /// `direction` of length 1. Thread-safe.
  std::optional<Hit> cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                          double max_range_m) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace ribbon_mapper::sim
