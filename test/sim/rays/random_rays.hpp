// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "sim/rays/ray_caster.hpp"

namespace ribbon_mapper::sim {

/// Reproducible random points and rays.
class RandomRays {
 public:
  /// Returns a point of the cube from -1 to 1.
  Eigen::Vector3d within_cube() {
    const double x = uniform_(random_), y = uniform_(random_), z = uniform_(random_);
    return {x, y, z};
  }

  /// Returns a ray from a random place `distance_m` away towards the cube from -1 to 1.
  Ray towards_origin(double distance_m) {
    const Eigen::Vector3d origin = distance_m * within_cube().normalized();
    return {origin, (within_cube() - origin).normalized()};
  }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

}  // namespace ribbon_mapper::sim
