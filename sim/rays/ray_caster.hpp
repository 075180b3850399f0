// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {

/// A ray in map.
struct Ray {
  Eigen::Vector3d origin;     ///< start of the ray [m]
  Eigen::Vector3d direction;  ///< of unit length
};

/// The first surface that a ray meets.
struct Hit {
  double range_m = 0.0;  ///< distance from the ray's origin
  int face = -1;         ///< index into World::faces()
};

/// Finds the first surface along a ray in a fixed set of triangles. Both sides of a triangle are
/// solid. Implementations may be used by several threads at once, and the same ray gives the same
/// bytes each time.
class RayCaster {
 public:
  RayCaster() = default;
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;
  virtual ~RayCaster() = default;

  /// Returns the first hit nearer than `max_range_m`, or nothing if there is none.
  virtual std::optional<Hit> cast(const Ray& ray, double max_range_m) const = 0;
};

/// The library that casts the rays.
enum class RayCasterKind {
  bullet,  ///< Bullet in double precision: the default, always available
  embree,  ///< Embree 3 or 4: several times faster, available if it was found when building
};

/// Returns the kind called `name`: bullet or embree. Throws std::invalid_argument that lists the
/// names if there is no such kind, or names the missing package if this build lacks it.
RayCasterKind ray_caster_kind_from(const std::string& name);

/// Returns true if this build can make casters of `kind`.
bool is_available(RayCasterKind kind);

/// Returns a caster for `triangles`, which need not outlive the call. Throws std::invalid_argument
/// that names the missing package if `kind` is not available.
std::unique_ptr<const RayCaster> make_ray_caster(RayCasterKind kind,
                                                 const std::vector<Triangle>& triangles);

}  // namespace ribbon_mapper::sim
