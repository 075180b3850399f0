// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "modeler/map/grid_keys.hpp"
#include "modeler/map/plane.hpp"
#include "modeler/map/posed_ribbon.hpp"

namespace ribbon_mapper {

/// The grid of a plane while it is filled: seen, count, mean and variance of each cell (section 6).
/// Space for it is taken in tiles where something was seen.
class CellGrid {
 public:
  /// `frame` says where the plane and its axes are; its cells are ignored.
  explicit CellGrid(const Plane& frame);

  void add(const PosedRibbon& ribbon);
  void add(const Eigen::Vector3d& point, std::uint32_t count);
  /// Sorted by (v, u). Leaves out what noise spilled: it carries a few points over the edge of what
  /// many have seen.
  std::vector<PlaneCell> cells() const;

 private:
  static constexpr int tile_bits = 4, tile_side = 1 << tile_bits;
  struct Sums {
    float count = 0.0F, distance_m = 0.0F, square_m2 = 0.0F;
  };
  struct Tile {
    explicit Tile(int column_, int row_) : column(column_), row(row_) {}
    int column, row;
    Sums sums[tile_side * tile_side];
  };
  struct Counts;

  Tile& tile_at(int column, int row);
  Counts counts_around(const Tile& tile) const;

  Eigen::Matrix3d to_grid_;  // rows: axis_u, axis_v in cells; normal in metres
  Eigen::Vector3d grid_shift_;
  tsl::robin_map<std::uint64_t, std::unique_ptr<Tile>, KeyHash> tiles_;
  Tile* last_ = nullptr;
};

/// Component of each cell, numbered by size from 0 (the largest) on: cells whose centres lie within
/// `gap_m` of each other are connected (single linkage).
std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m);

}  // namespace ribbon_mapper
