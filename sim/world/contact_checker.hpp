// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// Detects contacts between a box and the solids of a world. Primitive shapes are tested as solids
/// by Bullet, so a box inside one is detected. Meshes are hollow to Bullet; a box inside one is
/// detected by the winding number.
class ContactChecker {
 public:
  /// Prepares the contact test for `shapes`, which it copies.
  explicit ContactChecker(const std::vector<Shape>& shapes);
  ~ContactChecker();

  /// Returns the name of the shape that the box of `size_m` penetrates deepest, nothing if the box
  /// is free. Not for several threads at once.
  std::optional<std::string> contact(const Pose& T_map_box, const Eigen::Vector3d& size_m);

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace ribbon_mapper::sim
