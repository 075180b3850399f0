// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "slam/matching/level_scan.hpp"

namespace ribbon_mapper::slam {

/// The points of several scans as one smooth surface: where it is near a point, and its normal.
///
/// The surface is a moving average of the points' tangents (implicit moving least squares, Kolluri
/// 2008), which averages the noise of the points. Points are merged in cells first.
class SurfaceMap {
 public:
  /// The surface near a point.
  struct Tangent {
    double distance_m = 0.0;  ///< of the point in front of the surface; negative: behind
    double normal_x = 0.0;    ///< of unit length with normal_y
    double normal_y = 0.0;    ///< see normal_x
  };

  /// Makes a map of points. Those without a normal are left out.
  explicit SurfaceMap(const LevelPoints& points);

  /// Returns the surface that faces the same side as the point, averaged over `width_m`; nothing if
  /// there is none within `gate_m`, which is kReach_m at most.
  std::optional<Tangent> near(const LevelPoint& point, double width_m, double gate_m) const;

  /// Returns whether there is no surface.
  bool empty() const { return cells_.empty(); }

  static constexpr double kReach_m = 0.3;  ///< the farthest surface that is found

 private:
  struct Cell {
    float x = 0.0F, y = 0.0F, normal_x = 0.0F, normal_y = 0.0F, weight = 0.0F;
  };
  void index(std::vector<Cell> cells);

  double left_m_ = 0.0, bottom_m_ = 0.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_;  ///< of each square of kReach_m
  std::vector<Cell> cells_;           ///< in the order of their squares
};

}  // namespace ribbon_mapper::slam
