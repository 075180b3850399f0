// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/maps/navigation_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ribbon_mapper {
namespace {

constexpr float kNoFloor = std::numeric_limits<float>::quiet_NaN();

/// A rectangle of columns of voxels.
struct Columns {
  std::int32_t x_begin = std::numeric_limits<std::int32_t>::max(), y_begin = x_begin;
  std::int32_t x_end = std::numeric_limits<std::int32_t>::min(), y_end = x_end;

  void extend(const MapVoxel& voxel) {
    x_begin = std::min(x_begin, voxel[0]), x_end = std::max(x_end, voxel[0] + 1);
    y_begin = std::min(y_begin, voxel[1]), y_end = std::max(y_end, voxel[1] + 1);
  }
  bool holds(std::int32_t x, std::int32_t y) const {
    return x >= x_begin && x < x_end && y >= y_begin && y < y_end;
  }
  std::size_t width() const { return static_cast<std::size_t>(x_end - x_begin); }
  std::size_t height() const { return static_cast<std::size_t>(y_end - y_begin); }
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y - y_begin) * width() + static_cast<std::size_t>(x - x_begin);
  }
};

/// Returns the height of the floor in each column: that of the robot's nearest place, counted in
/// steps from column to column. Where it came twice, the later height counts.
std::vector<float> floor_heights_m(const Columns& columns, const SightLines& sights,
                                   double voxel_m) {
  std::vector<float> heights(columns.width() * columns.height(), kNoFloor);
  std::vector<std::array<std::int32_t, 2>> queue;
  queue.reserve(heights.size());
  for (const Eigen::Vector3f& base : sights.bases) {
    const auto x = floor_to_int(base.x() / voxel_m), y = floor_to_int(base.y() / voxel_m);
    if (!columns.holds(x, y)) continue;
    float& height = heights[columns.index(x, y)];
    if (std::isnan(height)) queue.push_back({x, y});
    height = base.z();
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const auto [x, y] = queue[i];
    const float height = heights[columns.index(x, y)];
    for (const auto [dx, dy] : {std::array{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (!columns.holds(x + dx, y + dy)) continue;
      float& other = heights[columns.index(x + dx, y + dy)];
      if (!std::isnan(other)) continue;
      other = height;
      queue.push_back({x + dx, y + dy});
    }
  }
  return heights;
}

/// What the voxels of a column say.
struct Column {
  std::int32_t free = 0;  // voxels
  bool is_occupied = false;
};

std::int8_t cell_of(const Column& column, double least_free) {
  if (column.is_occupied) return NavigationMap::kOccupied;
  return column.free >= least_free ? NavigationMap::kFree : NavigationMap::kUnknown;
}

}  // namespace

NavigationMap make_navigation_map(const VoxelMap& voxels, const SightLines& sights,
                                  const MapsConfig& config) {
  NavigationMap map;
  const double voxel_m = map.cell_m = voxels.voxel_m();
  Columns columns;
  voxels.for_each([&](const MapVoxel& voxel, VoxelState) { columns.extend(voxel); });
  if (columns.x_begin >= columns.x_end) return map;
  map.corner_m =
      voxels.origin().head<2>() + voxel_m * Eigen::Vector2d(columns.x_begin, columns.y_begin);
  map.width = columns.width(), map.height = columns.height();
  const std::vector<float> floors_m = floor_heights_m(columns, sights, voxel_m);
  std::vector<Column> seen(floors_m.size());
  voxels.for_each([&](const MapVoxel& voxel, VoxelState state) {
    const std::size_t i = columns.index(voxel[0], voxel[1]);
    const double height_m = (voxel[2] + 0.5) * voxel_m - static_cast<double>(floors_m[i]);
    if (!(height_m >= config.obstacle_min_m && height_m < config.obstacle_max_m)) return;
    if (state == VoxelState::occupied) seen[i].is_occupied = true;
    if (state == VoxelState::free) ++seen[i].free;
  });
  const double least_free =
      config.min_free_share * (config.obstacle_max_m - config.obstacle_min_m) / voxel_m;
  for (const Column& column : seen) map.cells.push_back(cell_of(column, std::max(1.0, least_free)));
  return map;
}

}  // namespace ribbon_mapper
