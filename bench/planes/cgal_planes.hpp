// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <utility>
#include <vector>

#include "bench/planes/planes_peer.hpp"

namespace ribbon_mapper::bench::cgal {

/// CGAL's geometry kernel.
using Kernel = CGAL::Simple_cartesian<double>;
/// A point with its normal.
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
/// A point cloud with normals.
using Cloud = std::vector<PointWithNormal>;
/// Access to the points of a cloud.
using PointMap = CGAL::First_of_pair_property_map<PointWithNormal>;
/// Access to the normals of a cloud.
using NormalMap = CGAL::Second_of_pair_property_map<PointWithNormal>;

/// Converts points and estimates their normals from the nearest neighbours.
inline Cloud with_normals(const Points& points, unsigned int neighbours) {
  Cloud cloud;
  cloud.reserve(points.size());
  for (const Eigen::Vector3f& p : points) {
    cloud.push_back({Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(0, 0, 0)});
  }
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      cloud, neighbours, CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  return cloud;
}

/// Returns the points with the given indices.
template <typename Indices>
Points points_of(const Cloud& cloud, const Indices& indices) {
  Points points;
  for (const std::size_t i : indices) {
    const Kernel::Point_3& p = cloud[i].first;
    points.push_back(Eigen::Vector3d(p.x(), p.y(), p.z()).cast<float>());
  }
  return points;
}

}  // namespace ribbon_mapper::bench::cgal
