// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "modeler/geometry/grid_keys.hpp"
#include "modeler/observations/posed_ribbon.hpp"
#include "modeler/surface/plane.hpp"
#include "modeler/surface/two_sided_vector.hpp"

namespace ribbon_mapper {

/// The grid of a plane while it is filled: seen, count, mean and variance of each cell (section 6).
/// Space for it is taken in tiles where something was seen.
class CellGrid {
 public:
  /// `frame` says where the plane and its axes are; its cells are ignored.
  explicit CellGrid(const Plane& frame);

  /// Column and row, with fractions, and distance from the plane [m].
  Eigen::Vector3d place_of(const Eigen::Vector3d& point) const {
    return to_grid_.col(0) * point.x() + to_grid_.col(1) * point.y() + to_grid_.col(2) * point.z() +
           grid_shift_;
  }

  void add(const PosedSamples& ribbon);
  void add(const Eigen::Vector3d& point, std::uint32_t count) { add_at(place_of(point), count); }
  /// A point whose place is known.
  void add_at(const Eigen::Vector3d& place, std::uint32_t count) {
    const int u = floor_to_int(place.x()), v = floor_to_int(place.y());
    const auto distance_m = static_cast<float>(place.z());
    tile_of(u, v).at(u, v).add(static_cast<float>(count), distance_m, 0.0F);
  }

  /// Sorted by (v, u). Leaves out what noise spilled: it carries a few points over the edge of what
  /// many have seen.
  std::vector<PlaneCell> cells() const;

 private:
  static constexpr int tile_bits = 4, tile_side = 1 << tile_bits;

  struct Sums {
    void add(float points, float distance, float own_square_m2) {
      count += points;
      distance_m += points * distance;
      square_m2 += points * (distance * distance + own_square_m2);
    }
    float count = 0.0F, distance_m = 0.0F, square_m2 = 0.0F;
  };

  /// Cells [u0, u0 + side) x [v0, v0 + side).
  struct Tile {
    Tile(int u0_, int v0_) : u0(u0_), v0(v0_) {}

    bool covers(int u, int v) const {
      return static_cast<unsigned>((u - u0) | (v - v0)) < unsigned{tile_side};
    }
    Sums& at(int u, int v) { return sums[(v - v0) * tile_side + (u - u0)]; }
    const Sums& at(int u, int v) const { return sums[(v - v0) * tile_side + (u - u0)]; }

    int u0, v0;
    std::array<Sums, tile_side * tile_side> sums;
  };
  using TileRow = TwoSidedVector<std::unique_ptr<Tile>>;
  struct Screened;

  Tile& tile_of(int u, int v);
  void append_cells(int row, std::vector<PlaneCell>& cells) const;

  Eigen::Matrix3d to_grid_;  // rows: axis_u, axis_v in cells; normal in metres
  Eigen::Vector3d grid_shift_;
  TwoSidedVector<TileRow> tiles_;  // by row, then column of tiles
};

/// Component of each cell, numbered by size from 0 (the largest) on: cells whose centres lie within
/// `gap_m` of each other are connected (single linkage). Cells are sorted as a plane's.
std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m);

}  // namespace ribbon_mapper
