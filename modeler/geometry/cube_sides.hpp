// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace ribbon_mapper {

/// Number of sides of a cube. They are numbered -x, x, -y, y, -z, z and classify directions.
constexpr int kCubeSides = 6;

/// Returns the side of a cube that a direction from its centre points through, in 0..5.
inline int cube_side(const Eigen::Vector3d& direction) {
  Eigen::Index axis;
  direction.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<int>(axis) + (direction[axis] < 0.0 ? 0 : 1);
}

/// A set of sides of a cube, one bit for each side.
using CubeSides = std::uint8_t;

/// Returns the side with the smallest number. The set must not be empty.
inline int first_side(CubeSides sides) { return __builtin_ctz(sides); }

/// Calls function(side) for each side of the set, in ascending order.
template <typename Function>
void for_each_side(CubeSides sides, const Function& function) {
  for (unsigned left = sides; left != 0; left &= left - 1) function(__builtin_ctz(left));
}

/// Returns the sides that unit vectors within a distance `reach` of the unit vector `direction`
/// point through. Near a corner of the cube, a side may be returned in excess.
inline CubeSides cube_sides_within(const Eigen::Vector3d& direction, double reach) {
  // A vector that points through another side differs from `direction` so much that two of its
  // coordinates become equal on the way: they differ by at most sqrt(2) * reach here.
  const double min_coordinate = direction.cwiseAbs().maxCoeff() - M_SQRT2 * reach;
  CubeSides sides = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sides |= static_cast<CubeSides>((-direction[axis] >= min_coordinate) << (2 * axis));
    sides |= static_cast<CubeSides>((direction[axis] >= min_coordinate) << (2 * axis + 1));
  }
  return sides;
}

}  // namespace ribbon_mapper
