// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/rays/ray_caster.hpp"
#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {

/// The collision shapes of an SDF world, fixed for good. Its frame is `map`.
class World {
 public:
  /// Reads an SDF file: box, cylinder, sphere, plane and mesh collisions. `model_paths` are
  /// searched for `model://` and relative URIs after the file's own folder. Throws
  /// std::runtime_error that names the file and says what to do if it is missing, broken or without
  /// a collision, or if an include or mesh of it is not found.
  static World load(const std::string& path, const std::vector<std::string>& model_paths = {});

  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// First surface along a ray (`direction` of length 1, both in map), from either side.
  std::optional<Hit> cast(const Eigen::Vector3d& origin_map, const Eigen::Vector3d& direction_map,
                          double max_range_m) const;

  /// The same for each ray of a scan line, all together: faster (RayCaster::cast_line).
  std::vector<std::optional<Hit>> cast_line(const std::vector<Ray>& rays, double max_range_m) const;

  const std::vector<Face>& faces() const;
  const std::vector<Triangle>& triangles() const;

  /// Name (model::link::collision) of a solid that a box of `size_m` meets, nothing if it is free.
  /// Not for several threads at once.
  std::optional<std::string> contact(const Pose& T_map_box, const Eigen::Vector3d& size_m) const;

  /// Where the surfaces cut the height `z_m`: segments for a top view.
  std::vector<std::array<Eigen::Vector2d, 2>> outlines_at(double z_m) const;

 private:
  struct State;
  explicit World(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
