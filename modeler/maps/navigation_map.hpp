// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/maps/maps_config.hpp"
#include "modeler/maps/voxel_map.hpp"

namespace ribbon_mapper {

/// Where a robot can drive: a level grid of cells, seen from above.
struct NavigationMap {
  static constexpr std::int8_t kUnknown = -1;    ///< not seen well enough
  static constexpr std::int8_t kFree = 0;        ///< nothing stands here
  static constexpr std::int8_t kOccupied = 100;  ///< an obstacle

  double cell_m = 0.05;                                ///< side of a cell [m]
  Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();  ///< corner of the first cell, in map [m]
  std::size_t width = 0;                               ///< cells along x
  std::size_t height = 0;                              ///< cells along y
  /// Row by row from the lowest y, each from the lowest x: the order of nav_msgs/OccupancyGrid.
  std::vector<std::int8_t> cells;
};

/// Returns the level map of a voxel map.
///
/// A cell is occupied if a voxel above it is, from MapsConfig::obstacle_min_m to
/// MapsConfig::obstacle_max_m above the floor. It is free if none is and beams passed enough of
/// these voxels. The floor is where the robot stood: each cell has that of the nearest place.
NavigationMap make_navigation_map(const VoxelMap& voxels, const SightLines& sights,
                                  const MapsConfig& config);

}  // namespace ribbon_mapper
