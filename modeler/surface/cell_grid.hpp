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

/// Accumulates the cells of a plane's grid: count, mean and variance of the points in each (section
/// 6 of the paper). Memory is allocated in tiles where something was seen.
class CellGrid {
 public:
  /// Creates an empty grid on the plane and axes of `frame`, whose cells are ignored.
  explicit CellGrid(const Plane& frame);

  /// Returns the position of a point in the grid: fractional column and row [cells], and distance
  /// from the plane [m].
  Eigen::Vector3d grid_position(const Eigen::Vector3d& point) const {
    return to_grid_.col(0) * point.x() + to_grid_.col(1) * point.y() + to_grid_.col(2) * point.z() +
           grid_shift_;
  }

  /// Adds the samples of a ribbon.
  void add(const PosedSamples& ribbon);
  /// Adds `count` points at the same point [m].
  void add(const Eigen::Vector3d& point, std::uint32_t count) {
    add_at(grid_position(point), count);
  }
  /// Adds `count` points at the same grid_position().
  void add_at(const Eigen::Vector3d& position, std::uint32_t count) {
    const int u = floor_to_int(position.x()), v = floor_to_int(position.y());
    const auto distance_m = static_cast<float>(position.z());
    tile_of(u, v).at(u, v).add(static_cast<float>(count), distance_m, 0.0F);
  }

  /// Returns the seen cells, sorted by (v, u). Leaves out cells with a few points that noise
  /// carried over the edge of a well-seen surface.
  std::vector<PlaneCell> cells() const;

 private:
  static constexpr int kTileBits = 4, kTileSide = 1 << kTileBits;

  /// Sums over the points of a cell.
  struct Sums {
    void add(float points, float distance, float own_square_m2) {
      count += points;
      distance_m += points * distance;
      square_m2 += points * (distance * distance + own_square_m2);
    }
    float count = 0.0F, distance_m = 0.0F, square_m2 = 0.0F;
  };

  /// The cells [u0, u0 + side) x [v0, v0 + side).
  struct Tile {
    Tile(int u0_, int v0_) : u0(u0_), v0(v0_) {}

    bool covers(int u, int v) const {
      return static_cast<unsigned>((u - u0) | (v - v0)) < unsigned{kTileSide};
    }
    Sums& at(int u, int v) { return sums[(v - v0) * kTileSide + (u - u0)]; }
    const Sums& at(int u, int v) const { return sums[(v - v0) * kTileSide + (u - u0)]; }

    int u0, v0;
    std::array<Sums, kTileSide * kTileSide> sums;
  };
  using TileRow = TwoSidedVector<std::unique_ptr<Tile>>;
  struct Screened;

  Tile& tile_of(int u, int v);
  void append_cells(int row, std::vector<PlaneCell>& cells) const;

  Eigen::Matrix3d to_grid_;  // rows: axis_u and axis_v [cells], normal [m]
  Eigen::Vector3d grid_shift_;
  TwoSidedVector<TileRow> tiles_;  // by row, then column of tiles
};

/// Returns the number of each cell's component, in descending order of size from 0 on.
///
/// Cells whose centres lie within `gap_m` of each other are connected (single linkage). The cells
/// must be sorted by (v, u).
std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m);

}  // namespace ribbon_mapper
