// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/true_voxels.hpp"

#include <cmath>
#include <limits>

namespace ribbon_mapper::eval {
namespace {

bool is_separated(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& half,
                  const Eigen::Vector3d& axis) {
  const double a = axis.dot(corners[0]), b = axis.dot(corners[1]), c = axis.dot(corners[2]);
  const double radius = half.dot(axis.cwiseAbs());
  return std::min({a, b, c}) > radius || std::max({a, b, c}) < -radius;
}

Eigen::AlignedBox3d box_of(const MapVoxel& voxel, double voxel_m, double part) {
  const Eigen::Vector3d centre =
      voxel_m * (Eigen::Vector3d(voxel[0], voxel[1], voxel[2]) + Eigen::Vector3d::Constant(0.5));
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * part * voxel_m);
  return {centre - half, centre + half};
}

int floor_of(double x) { return static_cast<int>(std::floor(x)); }

}  // namespace

bool touches(const std::array<Eigen::Vector3d, 3>& corners_m, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d centre = box.center(), half = 0.5 * box.sizes();
  std::array<Eigen::Vector3d, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = corners_m[i] - centre;
  const std::array<Eigen::Vector3d, 3> edges{corners[1] - corners[0], corners[2] - corners[1],
                                             corners[0] - corners[2]};
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    if (is_separated(corners, half, unit)) return false;
    for (const Eigen::Vector3d& edge : edges) {
      if (is_separated(corners, half, unit.cross(edge))) return false;
    }
  }
  return !is_separated(corners, half, edges[0].cross(edges[1]));
}

void TrueVoxels::add_surfaces(const std::vector<sim::Triangle>& triangles,
                              const Eigen::AlignedBox3d& box) {
  for (const sim::Triangle& triangle : triangles) add_surface(triangle, box);
}

void TrueVoxels::add_surface(const sim::Triangle& triangle, const Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& corner : triangle.corners_m) bounds.extend(corner);
  bounds = bounds.intersection(box);
  if (bounds.isEmpty()) return;
  const Eigen::Vector3d low = bounds.min() / voxel_m_, high = bounds.max() / voxel_m_;
  constexpr double kTouch = 1e-6;  // a surface between two voxels touches both
  for (int x = floor_of(low.x() - kTouch); x <= floor_of(high.x() + kTouch); ++x) {
    for (int y = floor_of(low.y() - kTouch); y <= floor_of(high.y() + kTouch); ++y) {
      for (int z = floor_of(low.z() - kTouch); z <= floor_of(high.z() + kTouch); ++z) {
        const MapVoxel voxel{x, y, z};
        if (!touches(triangle.corners_m, box_of(voxel, voxel_m_, 1.0 + kTouch))) continue;
        unsigned flags = kTouched;
        if (touches(triangle.corners_m, box_of(voxel, voxel_m_, 0.5))) flags |= kHeld;
        grid_.at(voxel) = static_cast<std::uint8_t>(grid_.at(voxel) | flags);
      }
    }
  }
}

void TrueVoxels::add_beams(const sim::Scan& scan) {
  for (std::size_t i = 0; i < scan.rays.size(); ++i) {
    const auto range_m = static_cast<double>(scan.true_ranges_m[i]);
    if (!std::isfinite(range_m) || !std::isfinite(scan.ranges_m[i])) continue;
    const sim::Ray& ray = scan.rays[i];
    add_way(ray.origin / voxel_m_, (ray.origin + range_m * ray.direction) / voxel_m_);
  }
}

/// Marks the voxels along a way, in voxels (Amanatides and Woo 1987).
void TrueVoxels::add_way(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  MapVoxel voxel{floor_of(from.x()), floor_of(from.y()), floor_of(from.z())};
  Eigen::Vector3d next;  // part of the way at which the next voxel along an axis begins
  for (int i = 0; i < 3; ++i) {
    const int border = voxel[static_cast<std::size_t>(i)] + (way[i] > 0.0 ? 1 : 0);
    next[i] = way[i] != 0.0 ? (border - from[i]) / way[i] : std::numeric_limits<double>::infinity();
  }
  while (true) {
    grid_.at(voxel) = static_cast<std::uint8_t>(grid_.at(voxel) | kPassed);
    Eigen::Index axis = 0;
    if (next.minCoeff(&axis) >= 1.0) return;
    voxel[static_cast<std::size_t>(axis)] += way[axis] > 0.0 ? 1 : -1;
    next[axis] += 1.0 / std::abs(way[axis]);
  }
}

bool TrueVoxels::is_near(const MapVoxel& voxel, unsigned flag) const {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        if ((grid_[{voxel[0] + dx, voxel[1] + dy, voxel[2] + dz}] & flag) != 0) return true;
      }
    }
  }
  return false;
}

}  // namespace ribbon_mapper::eval
