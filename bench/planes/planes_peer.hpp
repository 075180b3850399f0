// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "bench/planes/cloud.hpp"

namespace ribbon_mapper::bench {

/// A point cloud.
using Points = std::vector<Eigen::Vector3f>;

/// A method that finds planes in the points of a whole tour. One call includes type conversion,
/// search trees, normals and planes.
struct PlanesPeer {
  std::string name;  ///< for the report
  /// Returns the points of each plane.
  std::function<std::vector<Points>(const Points&)> planes_of;
};

/// Returns the centroid of each occupied voxel (pcl::VoxelGrid).
Points voxel_grid(const Points& points, float voxel_m);

/// Density of the points, which determines the best parameters of each peer.
enum class Density {
  dense,   ///< raw points
  sparse,  ///< one point per voxel
};

/// Returns PCL's region growing.
PlanesPeer pcl_region_growing(Density density);

/// Returns CGAL's region growing.
PlanesPeer cgal_region_growing(Density density);

/// Returns CGAL's efficient RANSAC.
PlanesPeer cgal_efficient_ransac(Density density);

/// Returns the points of PCL's organised multi-plane segmentation of each sweep, in map.
std::vector<Points> pcl_organised_planes(const std::vector<Sweep>& sweeps);

}  // namespace ribbon_mapper::bench
