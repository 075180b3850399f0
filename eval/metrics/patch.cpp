// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/patch.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>

namespace ribbon_mapper::eval {
namespace {

std::int32_t grid_index(double distance_m, double cell_size_m) {
  return static_cast<std::int32_t>(std::floor(distance_m / cell_size_m));
}

}  // namespace

Patch patch_of(const Plane& plane) {
  Patch patch{plane.normal, plane.d_m, plane.area_m2, plane.axis_u, {}};
  patch.cells.reserve(plane.cells.size());
  for (const PlaneCell& cell : plane.cells) patch.cells.push_back(cell_centre(plane, cell));
  return patch;
}

std::vector<Patch> patches_of(const std::vector<Plane>& planes) {
  std::vector<Patch> patches;
  patches.reserve(planes.size());
  for (const Plane& plane : planes) patches.push_back(patch_of(plane));
  return patches;
}

Plane plane_of(const Patch& patch, std::int64_t id, double cell_size_m) {
  Plane plane;
  plane.cell_size_m = cell_size_m;
  plane.id = id;
  plane.normal = patch.normal;
  plane.d_m = patch.d_m;
  plane.area_m2 = patch.area_m2;
  plane.centroid = centroid_of(patch);
  plane.axis_u = patch.axis_u.value_or(patch.normal.unitOrthogonal());
  plane.axis_v = patch.normal.cross(plane.axis_u);
  plane.origin = plane.centroid;
  if (!patch.cells.empty()) {  // the corner of a cell
    plane.origin = patch.cells.front() - 0.5 * cell_size_m * (plane.axis_u + plane.axis_v);
  }
  std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t> counts;  // by (v, u)
  for (const Eigen::Vector3d& centre : patch.cells) {
    const Eigen::Vector3d offset = centre - plane.origin;
    ++counts[{grid_index(offset.dot(plane.axis_v), plane.cell_size_m),
              grid_index(offset.dot(plane.axis_u), plane.cell_size_m)}];
  }
  for (const auto& [v_u, count] : counts) {
    plane.cells.push_back({v_u.second, v_u.first, count, 0.0F, 0.0F});
  }
  return plane;
}

Eigen::Vector3d centroid_of(const Patch& patch) {
  if (patch.cells.empty()) return -patch.d_m * patch.normal;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& cell : patch.cells) sum += cell;
  return sum / static_cast<double>(patch.cells.size());
}

}  // namespace ribbon_mapper::eval
