// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/map/footprint.hpp"
#include "modeler/map/voxel_index.hpp"

namespace ribbon_mapper {
namespace {

/// The errors of a ribbon's points are one error, that of its pose: a ribbon counts as one
/// measurement of its mean. Parameters: see Plane::covariance.
Eigen::Matrix3d covariance_of(const Hypothesis& hypothesis, const Plane& plane) {
  const Eigen::Matrix3d spread = hypothesis.moments().covariance();
  Eigen::Matrix<double, 3, 2> axes;
  axes << plane.axis_u, plane.axis_v;
  const Eigen::Matrix2d extent = axes.transpose() * spread * axes;
  const double variance =
      hypothesis.fit().variances[0] / static_cast<double>(hypothesis.members().size());
  const Eigen::Matrix2d slopes = variance * extent.inverse();  // of d(height)/du, d(height)/dv
  Eigen::Matrix2d to_rotations;
  to_rotations << 0.0, 1.0, -1.0, 0.0;  // a slope along v is a rotation about u
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = to_rotations * slopes * to_rotations.transpose();
  covariance(2, 2) = variance;
  return covariance;
}

Plane frame_of(const Hypothesis& hypothesis, const PlaneMapConfig& config) {
  Plane plane;
  plane.id = hypothesis.id;
  plane.cell_size_m = config.cell_size_m;
  plane.ribbon_count = hypothesis.members().size();
  for (const Member& member : hypothesis.members()) plane.ribbons.push_back(member.ribbon);
  std::sort(plane.ribbons.begin(), plane.ribbons.end());
  plane.normal = hypothesis.normal();
  plane.d_m = hypothesis.d_m();
  plane.origin = -plane.d_m * plane.normal;
  const bool is_level = std::abs(plane.normal.z()) > 0.9;
  const Eigen::Vector3d other = is_level ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  plane.axis_u = other.cross(plane.normal).normalized();  // horizontal on walls
  plane.axis_v = plane.normal.cross(plane.axis_u);
  plane.covariance = covariance_of(hypothesis, plane);
  return plane;
}

constexpr double voxel_m = 1.0;

VoxelIndex index_of(const std::vector<Surface>& surfaces) {
  VoxelIndex index(voxel_m);
  for (std::uint32_t slot = 0; slot < surfaces.size(); ++slot) {
    const Plane& plane = surfaces[slot].plane();
    std::vector<VoxelKey> keys;
    for (const PlaneCell& cell : plane.cells) {
      const VoxelKey key = index.key_of(cell_centre(plane, cell));
      if (keys.empty() || keys.back() != key) keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    index.enter(slot, keys);
  }
  return index;
}

/// Finds the surface that a single point lies on.
class StrayTaker {
 public:
  StrayTaker(const PlaneMapConfig& config, std::vector<Surface>& surfaces)
      : on_plane_m_(config.on_plane_m), surfaces_(surfaces), index_(index_of(surfaces)) {
    for (const Surface& surface : surfaces) {
      footprints_.emplace_back(surface.plane(), config.beside_plane_m);
    }
  }

  /// The nearest of those that face the sensor; none if all are too far.
  Surface* surface_of(const Eigen::Vector3d& point, const Eigen::Vector3d& sensor) {
    const VoxelKey key = index_.key_of(point);
    if (keys_.empty() || keys_[0] != key) keys_.assign(1, key), index_.near(keys_, near_);
    Surface* nearest = nullptr;
    double least_m = on_plane_m_;
    for (const std::uint32_t slot : near_) {
      const Plane& plane = surfaces_[slot].plane();
      const double distance = std::abs(plane.normal.dot(point) + plane.d_m);
      if (distance > least_m || plane.normal.dot(sensor) + plane.d_m <= 0.0) continue;
      if (!footprints_[slot].holds(point, on_plane_m_)) continue;
      nearest = &surfaces_[slot], least_m = distance;
    }
    return nearest;
  }

 private:
  double on_plane_m_;
  std::vector<Surface>& surfaces_;
  VoxelIndex index_;
  std::vector<Footprint> footprints_;
  std::vector<VoxelKey> keys_;      // of the last point
  std::vector<std::uint32_t> near_;  // surfaces near it
};

/// Which ribbons belong to a surface.
std::vector<bool> owned_ribbons(const Evidence& evidence, const std::vector<Surface>& surfaces) {
  std::vector<bool> owned(evidence.ribbons(), false);
  for (const Surface& surface : surfaces) {
    for (const std::uint32_t ribbon : surface.plane().ribbons) owned[ribbon] = true;
  }
  return owned;
}

/// A ribbon whose normal was spoilt, by an edge or a short base line, has joined no plane; most of
/// its points may lie on one all the same.
void take_lost_ribbons(const Evidence& evidence, StrayTaker& taker,
                       std::vector<Surface>& surfaces) {
  const std::vector<bool> owned = owned_ribbons(evidence, surfaces);
  std::map<Surface*, std::uint32_t> points;
  for (std::uint32_t index = 0; index < owned.size(); ++index) {
    if (owned[index]) continue;
    const Ribbon& ribbon = evidence.source(index);
    const Pose T_world_base = evidence.T_world_base(ribbon.pose);
    const Eigen::Vector3d sensor =
        T_world_base * evidence.strays(ribbon.pose).sensor.cast<double>();
    std::uint32_t all = 0;
    points.clear();
    for (const RibbonSample& sample : ribbon.samples) {
      const Eigen::Vector3d point = T_world_base * sample.point.cast<double>();
      all += sample.count;
      if (Surface* surface = taker.surface_of(point, sensor)) points[surface] += sample.count;
    }
    for (const auto& [surface, count] : points) {
      if (2 * count > all) surface->take(index, ribbon, T_world_base);
    }
  }
}

}  // namespace

Surface::Surface(const Hypothesis& hypothesis, const Evidence& evidence,
                 const PlaneMapConfig& config)
    : plane_(frame_of(hypothesis, config)), grid_(plane_) {
  for (const Member& member : hypothesis.members()) grid_.add(evidence.ribbon(member.ribbon));
  refresh();
}

void Surface::take(std::uint32_t index, const Ribbon& ribbon, const Pose& T_world_base) {
  for (const RibbonSample& sample : ribbon.samples) {
    grid_.add(T_world_base * sample.point.cast<double>(), sample.count);
  }
  plane_.ribbons.push_back(index);
}

void Surface::refresh() {
  std::sort(plane_.ribbons.begin(), plane_.ribbons.end());
  plane_.cells = grid_.cells();
  plane_.area_m2 = plane_.cells.size() * plane_.cell_size_m * plane_.cell_size_m;
  plane_.centroid.setZero();
  for (const PlaneCell& cell : plane_.cells) plane_.centroid += cell_centre(plane_, cell);
  plane_.centroid /= static_cast<double>(plane_.cells.size());
}

void take_strays(const Evidence& evidence, const PlaneMapConfig& config,
                 std::vector<Surface>& surfaces) {
  StrayTaker taker(config, surfaces);
  for (std::size_t line = 0; line < evidence.stray_lines(); ++line) {
    const StrayPoints& strays = evidence.strays(line);
    const Pose T_world_base = evidence.T_world_base(strays.pose);
    const Eigen::Vector3d sensor = T_world_base * strays.sensor.cast<double>();
    for (const RibbonSample& sample : strays.samples) {
      const Eigen::Vector3d point = T_world_base * sample.point.cast<double>();
      if (Surface* surface = taker.surface_of(point, sensor)) surface->add(point, sample.count);
    }
  }
  take_lost_ribbons(evidence, taker, surfaces);
  for (Surface& surface : surfaces) surface.refresh();
}

}  // namespace ribbon_mapper
