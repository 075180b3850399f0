// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/surface_map.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>

#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr float kCell_m = 0.06F;   // as wide as the noise of a cheap laser: finer gains nothing
constexpr double kSameSide = 0.6;  // cosine between normals of one surface, noise included

std::uint64_t key_of(const LevelPoint& p) {
  const auto x = static_cast<std::uint32_t>(floor_to_int(p.x_m / kCell_m));
  const auto y = static_cast<std::uint32_t>(floor_to_int(p.y_m / kCell_m));
  const std::uint64_t octant = (p.normal_x > 0.0F ? 1U : 0U) + (p.normal_y > 0.0F ? 2U : 0U) +
                               (std::abs(p.normal_x) > std::abs(p.normal_y) ? 4U : 0U);
  return (octant << 60) ^ (static_cast<std::uint64_t>(x) << 30) ^ y;
}

}  // namespace

SurfaceMap::SurfaceMap(const LevelPoints& points) {
  tsl::robin_map<std::uint64_t, std::uint32_t, KeyHash> places;
  places.reserve(points.size());
  std::vector<Cell> cells;
  cells.reserve(points.size());
  for (const LevelPoint& p : points) {
    if (p.normal_x == 0.0F && p.normal_y == 0.0F) continue;
    const auto [place, is_new] =
        places.emplace(key_of(p), static_cast<std::uint32_t>(cells.size()));
    if (is_new) cells.emplace_back();
    Cell& cell = cells[place->second];
    cell.x += p.x_m, cell.y += p.y_m, cell.weight += 1.0F;
    cell.normal_x += p.normal_x, cell.normal_y += p.normal_y;
  }
  for (Cell& cell : cells) {
    cell.x /= cell.weight, cell.y /= cell.weight;
    const float length = std::max(1e-6F, std::hypot(cell.normal_x, cell.normal_y));
    cell.normal_x /= length, cell.normal_y /= length;
  }
  index(std::move(cells));
}

/// Sorts the cells by squares.
void SurfaceMap::index(std::vector<Cell> cells) {
  if (cells.empty()) return;
  const auto by_x = std::minmax_element(cells.begin(), cells.end(),
                                        [](const Cell& a, const Cell& b) { return a.x < b.x; });
  const auto by_y = std::minmax_element(cells.begin(), cells.end(),
                                        [](const Cell& a, const Cell& b) { return a.y < b.y; });
  left_m_ = by_x.first->x - kReach_m, bottom_m_ = by_y.first->y - kReach_m;
  columns_ = floor_to_int((by_x.second->x - left_m_) / kReach_m) + 2;
  rows_ = floor_to_int((by_y.second->y - bottom_m_) / kReach_m) + 2;
  const auto square_of = [&](const Cell& cell) {
    return static_cast<std::size_t>(floor_to_int((cell.y - bottom_m_) / kReach_m)) * columns_ +
           floor_to_int((cell.x - left_m_) / kReach_m);
  };
  begin_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Cell& cell : cells) ++begin_[square_of(cell) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  cells_.resize(cells.size());
  for (const Cell& cell : cells) cells_[next[square_of(cell)]++] = cell;
}

std::optional<SurfaceMap::Tangent> SurfaceMap::near(const LevelPoint& point, double width_m,
                                                    double gate_m) const {
  const double fx = (point.x_m - left_m_) / kReach_m, fy = (point.y_m - bottom_m_) / kReach_m;
  if (!(fx >= 0.0 && fy >= 0.0 && fx < columns_ && fy < rows_)) return std::nullopt;
  const int column = static_cast<int>(fx), row = static_cast<int>(fy);
  const int first = std::max(0, column - 1), last = std::min(columns_ - 1, column + 1);
  double sum = 0.0, distance = 0.0, nx = 0.0, ny = 0.0;
  const double square_gate = gate_m * gate_m, square_width = width_m * width_m;
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
    const std::size_t line = static_cast<std::size_t>(r) * columns_;
    for (std::uint32_t i = begin_[line + first]; i < begin_[line + last + 1]; ++i) {
      const Cell& cell = cells_[i];
      const double dx = point.x_m - cell.x, dy = point.y_m - cell.y;
      const double square_distance = dx * dx + dy * dy;
      if (square_distance > square_gate) continue;
      if (point.normal_x * cell.normal_x + point.normal_y * cell.normal_y < kSameSide) continue;
      const double q = 1.0 / (1.0 + square_distance / square_width);
      const double weight = cell.weight * q * q * q;
      sum += weight, nx += weight * cell.normal_x, ny += weight * cell.normal_y;
      distance += weight * (dx * cell.normal_x + dy * cell.normal_y);
    }
  }
  const double length = std::hypot(nx, ny);
  if (!(sum > 0.0) || length < 1e-9) return std::nullopt;
  return Tangent{distance / sum, nx / length, ny / length};
}

}  // namespace ribbon_mapper::slam
