// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// Whether a box meets the solids of the world: Bullet's contact test with primitive shapes, so
/// that a box inside a solid is found too; for meshes, which are hollow to Bullet, by winding
/// number.
class ContactChecker {
 public:
  explicit ContactChecker(const std::vector<Shape>& shapes);
  ~ContactChecker();

  /// Name of a shape that the box of `size_m` meets (the deepest one), nothing if it is free.
  std::optional<std::string> contact(const Pose& T_map_box, const Eigen::Vector3d& size_m);

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace ribbon_mapper::sim
