// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/maps/voxel_map.hpp"

#include <tsl/robin_map.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "modeler/maps/passed_voxels.hpp"

namespace ribbon_mapper {
namespace {

constexpr auto kUnknown = static_cast<std::uint8_t>(VoxelState::unknown);
constexpr auto kFree = static_cast<std::uint8_t>(VoxelState::free);
constexpr auto kOccupied = static_cast<std::uint8_t>(VoxelState::occupied);
constexpr std::uint8_t kDisputed = 3;  // while the map is being made

// Log odds of OctoMap's 0.7 and 0.4. The third line that passes frees what was occupied, as it
// retracts planes: AssemblyConfig::passed_lines.
constexpr float kHit = 0.847F, kMiss = -0.405F;
constexpr float kLeastOdds = -2.0F, kMostOdds = -2.5F * kMiss;
constexpr double kMaxVoxels = 32000.0;  // an OctoMap reaches 32768 voxels along an axis
constexpr double kMaxColumns = 16e6;    // of the map for navigation: 400 MB while it is made

/// Returns a key of a voxel within +-10^6 voxels.
std::uint64_t key_of(const MapVoxel& voxel) {
  std::uint64_t key = 0;
  for (const std::int32_t i : voxel) {
    key = (key << 21) | (static_cast<std::uint64_t>(i + (1 << 20)) & 0x1fffffU);
  }
  return key;
}

/// Returns the box around all that a map holds, from the origin of the sights [m].
Eigen::AlignedBox3d box_of(const std::vector<Plane>& planes, const SightLines& sights) {
  Eigen::AlignedBox3d box;
  for (const SightLine& line : sights.lines) box.extend(line.sensor.cast<double>());
  for (const Fan& fan : sights.fans) {
    box.extend(fan.first.cast<double>()).extend(fan.last.cast<double>());
  }
  for (const LooseReturn& loose : sights.returns) box.extend(loose.point.cast<double>());
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) box.extend(cell_centre(plane, cell) - sights.origin);
  }
  return box;
}

/// Doubles the side of the voxels until an OctoMap holds the box, and the memory its columns.
double voxel_size_m(const Eigen::AlignedBox3d& box, double size_m) {
  if (box.isEmpty()) return size_m;
  const double reach_m = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const double area_m2 = box.sizes().head<2>().prod();
  while (reach_m > kMaxVoxels * size_m || area_m2 > kMaxColumns * size_m * size_m) size_m *= 2.0;
  return size_m;
}

/// Makes the map from the lines in the order of time.
class Carving {
 public:
  Carving(const SightLines& sights, const MapsConfig& config, double voxel_m)
      : sights_(sights),
        margin_(static_cast<float>(config.surface_margin_m / voxel_m)),
        per_voxel_(static_cast<float>(1.0 / voxel_m)) {}

  /// Occupies the voxels of a cell by four points half a cell apart, which leaves no holes in
  /// oblique planes.
  void occupy(const Plane& plane, const PlaneCell& cell) {
    const Eigen::Vector3d centre = cell_centre(plane, cell) - sights_.origin;
    const double quarter_m = 0.25 * plane.cell_size_m;
    for (const double du : {-quarter_m, quarter_m}) {
      for (const double dv : {-quarter_m, quarter_m}) {
        const Eigen::Vector3d point = centre + du * plane.axis_u + dv * plane.axis_v;
        grid_.at(voxel_at(per_voxel_ * point.cast<float>())) = kOccupied;
      }
    }
  }

  /// Disputes the voxels of loose returns, but those beside a plane: there its noise explains them.
  void dispute_returns() {
    for (const LooseReturn& loose : sights_.returns) {
      const MapVoxel voxel = voxel_at(per_voxel_ * loose.point);
      if (grid_[voxel] == kUnknown && !is_beside_plane(voxel)) grid_.at(voxel) = kDisputed;
    }
  }

  void carve() {
    std::uint32_t fan = 0, loose = 0;
    for (line_ = 0; line_ < sights_.lines.size(); ++line_) {
      const SightLine& line = sights_.lines[line_];
      for (std::uint32_t i = loose; i < line.end_return; ++i) hit(sights_.returns[i]);
      const Eigen::Vector3f sensor = per_voxel_ * line.sensor;
      for (; fan < line.end_fan; ++fan) carve_fan(sensor, sights_.fans[fan]);
      for (; loose < line.end_return; ++loose) carve_way(sensor, sights_.returns[loose]);
    }
  }

  /// Decides the disputes and hands the grid over.
  VoxelGrid decided() {
    grid_.change([this](const MapVoxel& voxel, std::uint8_t state) {
      if (state != kDisputed) return state;
      return disputes_[key_of(voxel)].odds > 0.0F ? kOccupied : kFree;
    });
    return std::move(grid_);
  }

 private:
  struct Dispute {
    float odds = 0.0F;         // logarithm
    std::uint32_t line = ~0U;  // the last one that was counted
  };

  bool is_beside_plane(const MapVoxel& voxel) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          if (grid_[{voxel[0] + dx, voxel[1] + dy, voxel[2] + dz}] == kOccupied) return true;
        }
      }
    }
    return false;
  }
  void count(const MapVoxel& voxel, float odds) {
    Dispute& dispute = disputes_[key_of(voxel)];
    if (dispute.line == line_) return;  // a hit counts before all that pass in the same line
    dispute.line = static_cast<std::uint32_t>(line_);
    dispute.odds = std::clamp(dispute.odds + odds, kLeastOdds, kMostOdds);
  }
  void hit(const LooseReturn& loose) {
    const MapVoxel voxel = voxel_at(per_voxel_ * loose.point);
    if (grid_[voxel] == kDisputed) count(voxel, kHit);
  }
  void pass(const MapVoxel& voxel) {
    std::uint8_t& state = grid_.at(voxel);
    if (state == kUnknown) {
      state = kFree;
    } else if (state == kDisputed) {
      count(voxel, kMiss);
    }
  }
  void carve_fan(const Eigen::Vector3f& sensor, const Fan& fan) {
    const auto end = [&](const Eigen::Vector3f& point) -> Eigen::Vector3f {
      return sensor + fan.free_part * (per_voxel_ * point - sensor);
    };
    for_each_voxel_of_triangle({sensor, end(fan.first), end(fan.last)},
                               [this](const MapVoxel& voxel) { pass(voxel); });
  }
  void carve_way(const Eigen::Vector3f& sensor, const LooseReturn& loose) {
    if (loose.has_fan) return;
    const Eigen::Vector3f way = per_voxel_ * loose.point - sensor;
    const float length = way.norm();
    if (length <= margin_) return;
    for_each_voxel_of_way(sensor, sensor + (1.0F - margin_ / length) * way,
                          [this](const MapVoxel& voxel) {
                            std::uint8_t& state = grid_.at(voxel);
                            if (state == kUnknown) state = kFree;
                          });
  }

  const SightLines& sights_;
  float margin_, per_voxel_;
  VoxelGrid grid_;
  tsl::robin_map<std::uint64_t, Dispute, KeyHash> disputes_;
  std::size_t line_ = 0;
};

}  // namespace

VoxelMap make_voxel_map(const std::vector<Plane>& planes, const SightLines& sights,
                        const MapsConfig& config) {
  const double voxel_m = voxel_size_m(box_of(planes, sights), config.voxel_m);
  Carving carving(sights, config, voxel_m);
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) carving.occupy(plane, cell);
  }
  carving.dispute_returns();
  carving.carve();
  return {voxel_m, sights.origin, carving.decided()};
}

}  // namespace ribbon_mapper
