// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

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
  std::vector<PlaneCell> cells() const;  ///< sorted by (v, u)

 private:
  static constexpr int tile_side = 32;
  static constexpr float spilled_share = 0.05F;  // of what the best neighbour has: 0.4 sigma in the plane over a cell
  struct Sums {
    float count = 0.0F, distance_m = 0.0F, square_m2 = 0.0F;
  };
  struct Tile {
    Sums sums[tile_side * tile_side];
  };
  Sums& at(int u, int v);
  float count_at(int u, int v) const;
  /// Noise carries a few points over the edge of what many have seen.
  bool is_spill(int u, int v, float count) const;

  Eigen::Matrix3d to_grid_;     // rows: axis_u, axis_v in cells; normal in metres
  Eigen::Vector3d grid_shift_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
  std::uint64_t last_key_ = 0;
  Tile* last_ = nullptr;
};

/// Component of each cell, numbered by size from 0 (the largest) on: cells whose centres lie within
/// `gap_m` of each other are connected (single linkage).
std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m);

}  // namespace ribbon_mapper
