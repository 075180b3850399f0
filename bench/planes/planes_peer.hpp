// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "bench/planes/cloud.hpp"

namespace ribbon_mapper::bench {

using Points = std::vector<Eigen::Vector3f>;

/// A way to planes from the points of a whole tour. One call does all of it: types of its own,
/// search trees, normals, planes.
struct PlanesPeer {
  std::string name;
  std::function<std::vector<Points>(const Points&)> planes_of;  ///< the points of each plane
};

/// Means over the occupied voxels (pcl::VoxelGrid).
Points voxel_grid(const Points& points, float voxel_m);

/// How dense the points are, so that each peer can be given what suits it best.
enum class Density { dense, sparse };

PlanesPeer pcl_region_growing(Density density);
PlanesPeer cgal_region_growing(Density density);
PlanesPeer cgal_efficient_ransac(Density density);

/// PCL's planes of organised clouds, sweep by sweep, in map.
std::vector<Points> pcl_organised_planes(const std::vector<Sweep>& sweeps);

}  // namespace ribbon_mapper::bench
