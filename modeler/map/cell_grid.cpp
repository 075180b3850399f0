// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

std::uint64_t key_of(int u, int v) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(u)) << 32) |
         static_cast<std::uint32_t>(v);
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

CellGrid::CellGrid(const Plane& frame) {
  to_grid_.row(0) = frame.axis_u.transpose() / frame.cell_size_m;
  to_grid_.row(1) = frame.axis_v.transpose() / frame.cell_size_m;
  to_grid_.row(2) = frame.normal.transpose();
  grid_shift_ = -to_grid_ * frame.origin;
}

CellGrid::Sums& CellGrid::at(int u, int v) {
  const int column = floor_div(u, tile_side), row = floor_div(v, tile_side);
  const std::uint64_t key = key_of(column, row);
  if (!last_ || key != last_key_) {
    std::unique_ptr<Tile>& tile = tiles_[key];
    if (!tile) tile = std::make_unique<Tile>();
    last_ = tile.get(), last_key_ = key;
  }
  return last_->sums[(v - row * tile_side) * tile_side + (u - column * tile_side)];
}

void CellGrid::add(const PosedRibbon& ribbon) {
  const Eigen::Matrix3d rotation = to_grid_ * ribbon.T_world_base.linear();
  const Eigen::Vector3d shift = to_grid_ * ribbon.T_world_base.translation() + grid_shift_;
  for (const RibbonSample& sample : ribbon.ribbon->samples) {
    const Eigen::Vector3d place = rotation * sample.point.cast<double>() + shift;
    Sums& sums = at(static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())));
    const float count = static_cast<float>(sample.count), distance = static_cast<float>(place.z());
    sums.count += count;
    sums.distance_m += count * distance;
    sums.square_m2 += count * (distance * distance + sample.square_m2);
  }
}

void CellGrid::add(const Eigen::Vector3d& point, std::uint32_t count) {
  const Eigen::Vector3d place = to_grid_ * point + grid_shift_;
  Sums& sums = at(static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())));
  const float weight = static_cast<float>(count), distance = static_cast<float>(place.z());
  sums.count += weight;
  sums.distance_m += weight * distance;
  sums.square_m2 += weight * distance * distance;
}

float CellGrid::count_at(int u, int v) const {
  const int column = floor_div(u, tile_side), row = floor_div(v, tile_side);
  const auto tile = tiles_.find(key_of(column, row));
  if (tile == tiles_.end()) return 0.0F;
  return tile->second->sums[(v - row * tile_side) * tile_side + (u - column * tile_side)].count;
}

bool CellGrid::is_spill(int u, int v, float count) const {
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      if (count < spilled_share * count_at(u + du, v + dv)) return true;
    }
  }
  return false;
}

std::vector<PlaneCell> CellGrid::cells() const {
  std::vector<PlaneCell> cells;
  for (const auto& [key, tile] : tiles_) {
    const int u0 = static_cast<std::int32_t>(key >> 32) * tile_side;
    const int v0 = static_cast<std::int32_t>(key & 0xffffffffu) * tile_side;
    for (int i = 0; i < tile_side * tile_side; ++i) {
      const Sums& sums = tile->sums[i];
      if (sums.count <= 0.0F) continue;
      PlaneCell cell;
      cell.u = u0 + i % tile_side;
      cell.v = v0 + i / tile_side;
      if (is_spill(cell.u, cell.v, sums.count)) continue;
      cell.count = static_cast<std::uint32_t>(sums.count);
      cell.mean_m = sums.distance_m / sums.count;
      cell.variance_m2 =
          std::max(0.0F, sums.square_m2 / sums.count - cell.mean_m * cell.mean_m);
      cells.push_back(cell);
    }
  }
  std::sort(cells.begin(), cells.end(), [](const PlaneCell& a, const PlaneCell& b) {
    return a.v != b.v ? a.v < b.v : a.u < b.u;
  });
  return cells;
}

}  // namespace ribbon_mapper
