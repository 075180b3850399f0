// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/point_assignment.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/geometry/voxel_key.hpp"
#include "modeler/surface/footprint.hpp"

namespace ribbon_mapper {
namespace {

/// Finds the surfaces that a point may lie on by the voxel of the point.
class SurfaceIndex {
 public:
  /// Creates an empty index. `reach_m` is the distance from the centre of a footprint's block to
  /// the furthest point that lies on it.
  explicit SurfaceIndex(double reach_m) : reach_m_(reach_m), voxels_per_m_(0.125 / reach_m) {}

  /// A surface with its plane in single precision, which rejects most points that are too far.
  struct Candidate {
    Eigen::Vector3f normal;
    float d_m;
    std::uint32_t surface;
  };

  /// Enters the footprint of a surface. Surfaces must be entered one after the other.
  void enter(std::uint32_t surface, const Footprint& footprint) {
    const Plane& plane = footprint.plane();
    const Candidate candidate{plane.normal.cast<float>(), static_cast<float>(plane.d_m), surface};
    VoxelKey last_low = kNoVoxel, last_high = kNoVoxel;
    footprint.for_each_block([&](const Eigen::Vector3d& centre) {
      const VoxelKey low = voxel_of(centre.array() - reach_m_);
      const VoxelKey high = voxel_of(centre.array() + reach_m_);
      if (low == last_low && high == last_high) return;
      last_low = low, last_high = high;
      for (int corner = 0; corner < (low == high ? 1 : 8); ++corner) {
        const Eigen::Array3d side(corner & 1, (corner >> 1) & 1, corner >> 2);
        enter(voxel_of(centre.array() + (2.0 * side - 1.0) * reach_m_), candidate);
      }
    });
  }

  /// Returns the surfaces near a point. Valid until the next call of enter().
  const std::vector<Candidate>& near(const Eigen::Vector3d& point) {
    const VoxelKey key = voxel_of(point);
    if (key != last_key_) {
      last_key_ = key;
      const auto found = candidates_.find(key);
      last_ = found == candidates_.end() ? &none_ : &found->second;
    }
    return *last_;
  }

 private:
  static constexpr VoxelKey kNoVoxel = ~VoxelKey{0};

  VoxelKey voxel_of(const Eigen::Vector3d& point) const { return voxel_key(voxels_per_m_ * point); }

  void enter(VoxelKey key, const Candidate& candidate) {
    std::vector<Candidate>& here = candidates_[key];
    if (here.empty() || here.back().surface != candidate.surface) here.push_back(candidate);
  }

  double reach_m_, voxels_per_m_;
  tsl::robin_map<VoxelKey, std::vector<Candidate>, KeyHash> candidates_;
  const std::vector<Candidate> none_;
  VoxelKey last_key_ = kNoVoxel;
  const std::vector<Candidate>* last_ = &none_;  // result of the latest query
};

/// Assigns points to the surfaces that they lie on.
class PointAssigner {
 public:
  PointAssigner(const AssemblyConfig& config, std::vector<Surface>& surfaces)
      : on_plane_m_(config.on_plane_m),
        surfaces_(surfaces),
        index_(1.001 * std::hypot(M_SQRT1_2 * config.beside_plane_m, config.on_plane_m)) {
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
      footprints_.emplace_back(surfaces[i].plane(), config.beside_plane_m);
      index_.enter(i, footprints_.back());
    }
  }

  /// Assigns the unassigned points of a line.
  void assign(const UnassignedPoints& unassigned, const Pose& T_model_base) {
    const Eigen::Matrix3d R_model_base = T_model_base.linear();
    const Eigen::Vector3d origin = T_model_base.translation();
    const Eigen::Vector3d sensor = R_model_base * unassigned.sensor.cast<double>() + origin;
    const auto faces = [&](const Plane& plane) {
      return plane.normal.dot(sensor) + plane.d_m > 0.0;
    };
    for (const PackedPoint& packed : unassigned) {
      const Eigen::Vector3d local = unassigned.point(packed).cast<double>();
      find(R_model_base.col(0) * local.x() + R_model_base.col(1) * local.y() +
               R_model_base.col(2) * local.z() + origin,
           packed.count, faces);
    }
    add_found();
  }

  /// Assigns the samples of a ribbon. The ribbon is added to the surface that most points lie on.
  void assign(const PosedSamples& ribbon, std::uint32_t index) {
    const auto faces = [&](const Plane& plane) {
      return plane.normal.dot(ribbon.normal) > kMinCosineOfSide;
    };
    std::uint32_t all = 0;
    ribbon.samples().for_each([&](float along_m, float height_m, std::uint32_t count) {
      all += count;
      find(ribbon.point(along_m, height_m), count, faces);
    });
    if (Surface* const surface = majority_of(all)) surface->add_ribbon(index);
    add_found();
  }

 private:
  /// Points at one position and the surface that they lie on.
  struct Assignment {
    Surface* surface;
    Eigen::Vector3d position;
    std::uint32_t count;
  };

  /// Records the nearest surface that faces the side from which the point was seen, if there is one
  /// near enough.
  template <typename Faces>
  void find(const Eigen::Vector3d& point, std::uint32_t count, const Faces& faces) {
    Assignment nearest{nullptr, point, count};
    double min_m = on_plane_m_;
    const Eigen::Vector3f rough = point.cast<float>();
    const float limit_m =
        static_cast<float>(on_plane_m_) + 1e-3F;  // with a margin far above rounding
    for (const auto& candidate : index_.near(point)) {
      if (std::abs(candidate.normal.dot(rough) + candidate.d_m) > limit_m) continue;
      Surface& surface = surfaces_[candidate.surface];
      const Eigen::Vector3d position = surface.grid_position(point);
      const double distance = std::abs(position.z());
      if (distance > min_m || !faces(surface.plane())) continue;
      if (!footprints_[candidate.surface].covers(position.x(), position.y())) continue;
      nearest.surface = &surface, nearest.position = position, min_m = distance;
    }
    if (nearest.surface) assignments_.push_back(nearest);
  }

  /// Adds the recorded points to their surfaces. Done for many points at once, so that the
  /// processor fetches several cells at a time, which are scattered in memory.
  void add_found() {
    for (const Assignment& found : assignments_) found.surface->add(found.position, found.count);
    assignments_.clear();
  }

  /// Returns the surface with more than half of all points, or null. Finds the only candidate by
  /// the majority vote of Boyer and Moore (1991), then counts its points.
  Surface* majority_of(std::uint32_t all) const {
    Surface* leader = nullptr;
    std::int64_t lead = 0, points = 0;
    for (const Assignment& found : assignments_) {
      lead += found.surface == leader ? found.count : -std::int64_t{found.count};
      if (lead < 0) leader = found.surface, lead = -lead;
    }
    for (const Assignment& found : assignments_)
      points += found.surface == leader ? found.count : 0;
    return 2 * points > all ? leader : nullptr;
  }

  double on_plane_m_;
  std::vector<Surface>& surfaces_;
  SurfaceIndex index_;
  std::vector<Footprint> footprints_;
  std::vector<Assignment> assignments_;  // of the present line or ribbon
};

/// Returns for each ribbon whether it belongs to a surface.
std::vector<bool> ribbons_of_surfaces(const std::vector<Surface>& surfaces, std::size_t count) {
  std::vector<bool> owned(count, false);
  for (const Surface& surface : surfaces) {
    for (const std::uint32_t ribbon : surface.plane().ribbons) owned[ribbon] = true;
  }
  return owned;
}

}  // namespace

void assign_points(const PosedObservations& observations, const AssemblyConfig& config,
                   std::vector<Surface>& surfaces) {
  PointAssigner assigner(config, surfaces);
  for (std::size_t line = 0; line < observations.unassigned().size(); ++line) {
    const UnassignedPoints& unassigned = observations.unassigned()[line];
    assigner.assign(unassigned, observations.T_model_base(unassigned.pose));
  }
  const std::vector<bool> owned = ribbons_of_surfaces(surfaces, observations.ribbon_count());
  for (std::uint32_t i = 0; i < owned.size(); ++i) {
    if (!owned[i]) assigner.assign(observations.samples(i), i);
  }
  for (Surface& surface : surfaces) surface.refresh();
}

}  // namespace ribbon_mapper
