// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/cell_grid.hpp"

#include <algorithm>
#include <array>

namespace ribbon_mapper {
namespace {

// Of what the best neighbour has: 0.4 sigma in the plane over a cell.
constexpr float spilled_share = 0.05F;

}  // namespace

/// Counts of a tile with a margin of one cell.
struct CellGrid::Counts {
  static constexpr int side = tile_side + 2;
  std::array<float, side * side> counts{};

  float most_of_all = 0.0F;

  void set(int u, int v, float count) {
    counts[(v + 1) * side + u + 1] = count;
    most_of_all = std::max(most_of_all, count);
  }
  bool is_spill(int u, int v) const {
    const float* centre = &counts[(v + 1) * side + u + 1];
    if (*centre >= spilled_share * most_of_all) return false;
    float most = 0.0F;
    for (const int row : {-side, 0, side}) {
      most = std::max({most, centre[row - 1], centre[row], centre[row + 1]});
    }
    return *centre < spilled_share * most;
  }
};

CellGrid::CellGrid(const Plane& frame) {
  to_grid_.row(0) = frame.axis_u.transpose() / frame.cell_size_m;
  to_grid_.row(1) = frame.axis_v.transpose() / frame.cell_size_m;
  to_grid_.row(2) = frame.normal.transpose();
  grid_shift_ = -to_grid_ * frame.origin;
}

CellGrid::Tile& CellGrid::tile_at(int column, int row) {
  if (last_ && last_->column == column && last_->row == row) return *last_;
  std::unique_ptr<Tile>& tile = tiles_[pair_key(column, row)];
  if (!tile) tile = std::make_unique<Tile>(column, row);
  return *(last_ = tile.get());
}

/// Along a ribbon, places in the grid are linear in the steps. Heights do not move a sample to
/// another cell: the ribbon is as good as parallel to the plane.
void CellGrid::add(const PosedRibbon& ribbon) {
  const RibbonSamples& samples = ribbon.ribbon->samples;
  const Eigen::Vector3d start = to_grid_ * ribbon.point(samples.start_m, 0.0F) + grid_shift_;
  const int u0 = floor_to_int(start.x()), v0 = floor_to_int(start.y());
  const Eigen::Vector3f first = (start - Eigen::Vector3d(u0, v0, 0.0)).cast<float>();
  const Eigen::Vector3f step =
      (to_grid_ * (RibbonSamples::along_step_m * ribbon.along)).cast<float>();
  const auto height_step =
      static_cast<float>(to_grid_.row(2).dot(ribbon.normal) * samples.height_step_m);
  int tile_column = 0, tile_row = 0;
  Sums* tile = nullptr;
  constexpr int mask = tile_side - 1;
  samples.for_each_packed([&](int steps, const PackedSample& sample) {
    const auto way = static_cast<float>(steps);
    const int column = u0 + floor_to_int(first.x() + way * step.x());
    const int row = v0 + floor_to_int(first.y() + way * step.y());
    if (!tile || tile_column != column >> tile_bits || tile_row != row >> tile_bits) {
      tile_column = column >> tile_bits, tile_row = row >> tile_bits;
      tile = tile_at(tile_column, tile_row).sums;
    }
    Sums& sums = tile[(row & mask) * tile_side + (column & mask)];
    const float count = sample.count;
    const float distance = first.z() + way * step.z() + sample.height * height_step;
    sums.count += count;
    sums.distance_m += count * distance;
    sums.square_m2 += count * (distance * distance + samples.variance_m2);
  });
}

void CellGrid::add(const Eigen::Vector3d& point, std::uint32_t count) {
  const Eigen::Vector3d place = to_grid_ * point + grid_shift_;
  const int column = floor_to_int(place.x()), row = floor_to_int(place.y());
  constexpr int mask = tile_side - 1;
  Sums& sums = tile_at(column >> tile_bits, row >> tile_bits)
                   .sums[(row & mask) * tile_side + (column & mask)];
  const float weight = static_cast<float>(count), distance = static_cast<float>(place.z());
  sums.count += weight;
  sums.distance_m += weight * distance;
  sums.square_m2 += weight * distance * distance;
}

CellGrid::Counts CellGrid::counts_around(const Tile& tile) const {
  Counts counts;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      const auto found = tiles_.find(pair_key(tile.column + du, tile.row + dv));
      if (found == tiles_.end()) continue;
      const auto first = [](int d) { return d < 0 ? tile_side - 1 : 0; };
      const auto end = [](int d) { return d > 0 ? 1 : tile_side; };
      for (int v = first(dv); v < end(dv); ++v) {
        for (int u = first(du); u < end(du); ++u) {
          counts.set(u + du * tile_side, v + dv * tile_side,
                     found->second->sums[v * tile_side + u].count);
        }
      }
    }
  }
  return counts;
}

std::vector<PlaneCell> CellGrid::cells() const {
  std::vector<const Tile*> tiles;
  for (const auto& [key, tile] : tiles_) tiles.push_back(tile.get());
  std::sort(tiles.begin(), tiles.end(), [](const Tile* a, const Tile* b) {
    return a->row != b->row ? a->row < b->row : a->column < b->column;
  });
  std::vector<PlaneCell> cells;
  std::vector<Counts> counts;
  for (std::size_t first = 0, end = 0; first < tiles.size(); first = end) {
    counts.clear();
    for (; end < tiles.size() && tiles[end]->row == tiles[first]->row; ++end) {
      counts.push_back(counts_around(*tiles[end]));
    }
    for (int v = 0; v < tile_side; ++v) {
      for (std::size_t i = first; i < end; ++i) {
        for (int u = 0; u < tile_side; ++u) {
          const Sums& sums = tiles[i]->sums[v * tile_side + u];
          if (sums.count <= 0.0F || counts[i - first].is_spill(u, v)) continue;
          PlaneCell cell;
          cell.u = tiles[i]->column * tile_side + u;
          cell.v = tiles[i]->row * tile_side + v;
          cell.count = static_cast<std::uint32_t>(sums.count);
          cell.mean_m = sums.distance_m / sums.count;
          cell.variance_m2 =
              std::max(0.0F, sums.square_m2 / sums.count - cell.mean_m * cell.mean_m);
          cells.push_back(cell);
        }
      }
    }
  }
  return cells;
}

}  // namespace ribbon_mapper
