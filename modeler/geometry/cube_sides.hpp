// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace ribbon_mapper {

/// Directions sorted by the side of a cube that they point through: -x, x, -y, y, -z, z.
constexpr int kCubeSides = 6;

inline int cube_side(const Eigen::Vector3d& direction) {
  Eigen::Index axis;
  direction.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<int>(axis) + (direction[axis] < 0.0 ? 0 : 1);
}

/// One bit for each side.
using CubeSides = std::uint8_t;

inline int first_side(CubeSides sides) { return __builtin_ctz(sides); }

template <typename Function>
void for_each_side(CubeSides sides, const Function& function) {
  for (unsigned left = sides; left != 0; left &= left - 1) function(__builtin_ctz(left));
}

/// The sides that unit vectors point through whose distance from `direction` (of the tips) is at
/// most `reach`; near a corner it may be one more.
inline CubeSides cube_sides_within(const Eigen::Vector3d& direction, double reach) {
  // Where two coordinates are equal at least on the way, they differ by no more than this.
  const double most = direction.cwiseAbs().maxCoeff() - M_SQRT2 * reach;
  CubeSides sides = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sides |= static_cast<CubeSides>((-direction[axis] >= most) << (2 * axis));
    sides |= static_cast<CubeSides>((direction[axis] >= most) << (2 * axis + 1));
  }
  return sides;
}

}  // namespace ribbon_mapper
