// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/map/plane.hpp"

namespace ribbon_mapper {

/// Where on a plane there are cells, in blocks as wide as a reach: which points lie on the plane
/// and beside what was seen of it. The plane must outlive it.
class Footprint {
 public:
  Footprint(const Plane& plane, double reach_m);

  /// Within `tolerance_m` of the plane and, in it, within the reach of a cell; true for no point
  /// that is further than twice the reach from all of them along an axis.
  bool holds(const Eigen::Vector3d& point, double tolerance_m) const;

  const Plane& plane() const { return *plane_; }

 private:
  const Plane* plane_;
  double blocks_per_m_;
  int u0_ = 0, v0_ = 0, columns_ = 0, rows_ = 0;
  std::vector<char> is_beside_;  // of each block: it or one around it holds a cell
};

}  // namespace ribbon_mapper
