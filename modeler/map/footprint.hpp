// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include <tsl/robin_set.h>

#include "modeler/map/key_hash.hpp"
#include "modeler/map/plane.hpp"

namespace ribbon_mapper {

/// Where on a plane there are cells, in blocks as wide as a reach: which points lie on the plane
/// and beside what was seen of it. The plane must outlive it.
class Footprint {
 public:
  Footprint(const Plane& plane, double reach_m);

  /// Within `tolerance_m` of the plane and, in it, within the reach of a cell; true for no point that
  /// is further than twice the reach from all of them along an axis.
  bool holds(const Eigen::Vector3d& point, double tolerance_m) const;

  const Plane& plane() const { return *plane_; }

 private:
  std::uint64_t block_at(double u_m, double v_m, int du, int dv) const;

  const Plane* plane_;
  double reach_m_;
  tsl::robin_set<std::uint64_t, KeyHash> blocks_;
};

}  // namespace ribbon_mapper
