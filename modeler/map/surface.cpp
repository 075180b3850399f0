// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/surface.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "modeler/map/footprint.hpp"
#include "modeler/map/voxel_key.hpp"

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

/// Which surfaces may be near a point, by voxels much wider than the reach of a footprint.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(const std::vector<Surface>& surfaces) {
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) enter(surfaces[i].plane(), i);
  }

  struct Candidate {
    Eigen::Vector3f normal;  // of the plane of a surface: tells most that are too far
    float d_m;
    std::uint32_t surface;
  };

  const std::vector<Candidate>& near(const Eigen::Vector3d& point) {
    const VoxelKey key = voxel_key(point, voxel_m);
    if (key != last_key_) {
      last_key_ = key;
      const auto found = surfaces_.find(key);
      last_ = found == surfaces_.end() ? nullptr : &found->second;
    }
    return last_ ? *last_ : none_;
  }

 private:
  static constexpr double voxel_m = 1.0;

  void enter(const Plane& plane, std::uint32_t surface) {
    keys_.clear();
    for (const PlaneCell& cell : plane.cells) {
      const VoxelKey key = voxel_key(cell_centre(plane, cell), voxel_m);
      if (keys_.empty() || keys_.back() != key) keys_.push_back(key);
    }
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    for (const VoxelKey key : keys_) {
      for_each_around(key, [&](VoxelKey around) {
        std::vector<Candidate>& here = surfaces_[around];
        if (!here.empty() && here.back().surface == surface) return;
        here.push_back({plane.normal.cast<float>(), static_cast<float>(plane.d_m), surface});
      });
    }
  }

  tsl::robin_map<VoxelKey, std::vector<Candidate>, KeyHash> surfaces_;
  std::vector<VoxelKey> keys_;  // scratch
  std::optional<VoxelKey> last_key_;
  const std::vector<Candidate>* last_ = nullptr;
  const std::vector<Candidate> none_;
};

/// Finds the surface that a single point lies on.
class StrayTaker {
 public:
  StrayTaker(const PlaneMapConfig& config, std::vector<Surface>& surfaces)
      : on_plane_m_(config.on_plane_m), surfaces_(surfaces), index_(surfaces) {
    for (const Surface& surface : surfaces) {
      footprints_.emplace_back(surface.plane(), config.beside_plane_m);
    }
  }

  void give(const StrayPoints& strays, const Pose& T_world_base) {
    const Eigen::Vector3d sensor = T_world_base * strays.sensor.cast<double>();
    const auto faces = [&](const Plane& plane) {
      return plane.normal.dot(sensor) + plane.d_m > 0.0;
    };
    for (const PackedPoint& packed : strays) {
      give(T_world_base * strays.point(packed).cast<double>(), packed.count, faces);
    }
  }

  /// The surface that most of the points were given to owns the ribbon.
  void give(const PosedSamples& ribbon, std::uint32_t index) {
    const auto faces = [&](const Plane& plane) {
      return plane.normal.dot(ribbon.normal) > least_cosine_of_side;
    };
    std::uint32_t all = 0;
    given_.clear();
    ribbon.samples.for_each([&](float along_m, float height_m, std::uint32_t count) {
      all += count;
      if (Surface* surface = give(ribbon.point(along_m, height_m), count, faces)) {
        given_[surface] += count;
      }
    });
    for (const auto& [surface, count] : given_) {
      if (2 * count > all) surface->own(index);
    }
  }

 private:
  template <typename Faces>
  Surface* give(const Eigen::Vector3d& point, std::uint32_t count, const Faces& faces) {
    Surface* surface = surface_of(point, faces);
    if (surface) surface->add(point, count);
    return surface;
  }

  /// The nearest of those that face the way that the point was seen from; none if all are too far.
  template <typename Faces>
  Surface* surface_of(const Eigen::Vector3d& point, const Faces& faces) {
    Surface* nearest = nullptr;
    double least_m = on_plane_m_;
    const Eigen::Vector3f rough = point.cast<float>();
    const float limit_m = static_cast<float>(on_plane_m_) + 1e-3F;  // above rounding
    for (const auto& candidate : index_.near(point)) {
      if (std::abs(candidate.normal.dot(rough) + candidate.d_m) > limit_m) continue;
      const std::uint32_t slot = candidate.surface;
      const Plane& plane = surfaces_[slot].plane();
      const double distance = std::abs(plane.normal.dot(point) + plane.d_m);
      if (distance > least_m || !faces(plane)) continue;
      if (!footprints_[slot].holds(point, on_plane_m_)) continue;
      nearest = &surfaces_[slot], least_m = distance;
    }
    return nearest;
  }

  double on_plane_m_;
  std::vector<Surface>& surfaces_;
  SurfaceIndex index_;
  std::vector<Footprint> footprints_;
  std::map<Surface*, std::uint32_t> given_;  // points of one ribbon
};

/// Of each ribbon, whether it belongs to a surface.
std::vector<bool> owned_ribbons(const std::vector<Surface>& surfaces, std::size_t count) {
  std::vector<bool> owned(count, false);
  for (const Surface& surface : surfaces) {
    for (const std::uint32_t ribbon : surface.plane().ribbons) owned[ribbon] = true;
  }
  return owned;
}

}  // namespace

Surface::Surface(const Hypothesis& hypothesis, const Evidence& evidence,
                 const PlaneMapConfig& config)
    : plane_(frame_of(hypothesis, config)), grid_(plane_) {
  for (const Member& member : hypothesis.members()) grid_.add(evidence.samples(member.ribbon));
  refresh();
}

void Surface::refresh() {
  if (!std::is_sorted(plane_.ribbons.begin(), plane_.ribbons.end())) {
    std::sort(plane_.ribbons.begin(), plane_.ribbons.end());
  }
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
    taker.give(strays, evidence.T_world_base(strays.pose));
  }
  const std::vector<bool> owned = owned_ribbons(surfaces, evidence.ribbon_count());
  for (std::uint32_t i = 0; i < owned.size(); ++i) {
    if (!owned[i]) taker.give(evidence.samples(i), i);
  }
  for (Surface& surface : surfaces) surface.refresh();
}

}  // namespace ribbon_mapper
