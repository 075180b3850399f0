// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {

struct RayScene;

struct Ray {
  Eigen::Vector3d origin, direction;  ///< in map; the direction of length 1
};

struct Hit {
  double range_m = 0.0;
  int face = -1;  ///< index into World::faces()
};

/// First surface along rays, from either side. The rays of a scan line are cast in packets of
/// neighbours that walk the tree together (Wald et al., "Interactive rendering with coherent ray
/// tracing", 2001). What a ray hits does not depend on the rays beside it, nor on the processor; of
/// surfaces at the very same range it is the first in the order of the triangles. Thread-safe.
class RayCaster {
 public:
  explicit RayCaster(const std::vector<Triangle>& triangles);
  ~RayCaster();

  std::optional<Hit> cast(const Ray& ray, double max_range_m) const;

  /// The same for each of many rays; fast if successive ones are near and alike, as beams are.
  std::vector<std::optional<Hit>> cast_line(const std::vector<Ray>& rays, double max_range_m) const;

 private:
  std::unique_ptr<const RayScene> scene_;
};

}  // namespace ribbon_mapper::sim
