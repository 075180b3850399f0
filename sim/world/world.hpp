// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/rays/ray_caster.hpp"
#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {

/// The collision shapes of an SDF world, which never change. The frame of the world is `map`.
class World {
 public:
  /// Reads an SDF file with box, cylinder, sphere, plane and mesh collisions. `model_paths` are
  /// searched for `model://` and relative URIs after the file's own folder; `caster` casts its
  /// rays. Models without a collision are taken from their visuals if `visuals` is true. What no
  /// laser sees is ignored. Throws std::runtime_error that names the file and says what to do: the
  /// file may be missing, broken, without collisions or of implausible size, or an include or mesh
  /// may be missing. Throws std::invalid_argument if this build lacks `caster`.
  static World load(const std::string& path, const std::vector<std::string>& model_paths = {},
                    RayCasterKind caster = RayCasterKind::bullet, bool visuals = false);

  /// Takes over the content of another world.
  World(World&&) noexcept;
  /// Takes over the content of another world.
  World& operator=(World&&) noexcept;
  ~World();

  /// Returns the first surface along a ray, seen from either side; nothing if there is none within
  /// `max_range_m`. The direction is of unit length. For several threads at once.
  std::optional<Hit> cast(const Eigen::Vector3d& origin_map, const Eigen::Vector3d& direction_map,
                          double max_range_m) const;

  /// Returns the faces that hits refer to.
  const std::vector<Face>& faces() const;

  /// Returns the triangles that rays are cast into.
  const std::vector<Triangle>& triangles() const;

  /// Returns the box around all shapes [m, map]; planes, which are unbounded, do not count.
  const Eigen::AlignedBox3d& extent_m() const;

  /// Returns in one line what was loaded and what was left out, for the user.
  const std::string& content() const;

  /// Returns a line for each thing in the file that its author should look at.
  const std::vector<std::string>& warnings() const;

  /// Returns the name (model::link::collision) of a solid that a box of `size_m` penetrates,
  /// nothing if the box is free. Not for several threads at once.
  std::optional<std::string> contact(const Pose& T_map_box, const Eigen::Vector3d& size_m) const;

  /// Returns where the surfaces cross the height `z_m`, as segments [m] of a top view.
  std::vector<std::array<Eigen::Vector2d, 2>> outlines_at(double z_m) const;

 private:
  struct State;
  explicit World(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
