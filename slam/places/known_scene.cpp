// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/known_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kVoxel_m = 0.15;  // finer than a door is wide
constexpr float kSpacing_m = 0.1F;
// A ray is blocked by walls that were seen here and to both sides, and this far before its end.
constexpr std::uint32_t kMinPoints = 2;
constexpr double kClearance_m = 0.5;

}  // namespace

LevelPoint seen_from_above(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const Eigen::Vector2f level = normal.head<2>().normalized().cast<float>();
  return {static_cast<float>(point.x()), static_cast<float>(point.y()), level.x(), level.y()};
}

std::vector<Eigen::Vector3d> points_along(const PosedRibbon& ribbon) {
  std::vector<Eigen::Vector3d> points;
  float last_m = -std::numeric_limits<float>::infinity();
  ribbon.samples().for_each([&](float along_m, float height_m, std::uint32_t) {
    if (along_m - last_m < kSpacing_m) return;
    last_m = along_m;
    points.push_back(ribbon.point(along_m, height_m));
  });
  return points;
}

KnownScene::KnownScene(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
                       const EstimateSettings& settings) {
  for (Hypothesis& plane : planes_of(lines, indices, settings.estimate.gates.back(), settings)) {
    if (!is_of_wall(plane.normal())) continue;
    const auto wall = static_cast<std::uint32_t>(walls_.size());
    walls_.push_back({std::move(plane), 0});
    for (const Member& member : walls_.back().plane.members()) {
      const PosedRibbon ribbon = lines.posed_ribbon(member.ribbon);
      walls_.back().last_line = std::max(walls_.back().last_line, ribbon.ribbon->pose);
      enter(wall, ribbon);
    }
  }
}

void KnownScene::enter(std::uint32_t wall, const PosedRibbon& ribbon) {
  for (const Eigen::Vector3d& point : points_along(ribbon)) {
    points_.push_back(seen_from_above(point, walls_[wall].plane.normal()));
    std::vector<Part>& parts = parts_[voxel_key(point, kVoxel_m)];
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.wall == wall; });
    if (part == parts.end())
      parts.push_back({wall, 1});
    else
      ++part->points;
  }
}

std::optional<std::uint32_t> KnownScene::wall_at(const Eigen::Vector3d& point,
                                                 const PosedRibbon& ribbon,
                                                 const AssociationGates& gates) const {
  const double max_sine = std::sin(gates.angle_deg * kDegree);
  std::optional<std::uint32_t> wall;
  for_each_around(voxel_key(point, kVoxel_m), [&](VoxelKey key) {
    if (wall) return;
    const auto found = parts_.find(key);
    if (found == parts_.end()) return;
    for (const Part& part : found->second) {
      const Hypothesis& plane = walls_[part.wall].plane;
      if (plane.normal().dot(ribbon.normal) > kMinCosineOfSide &&
          std::abs(plane.normal().dot(ribbon.along)) < max_sine &&
          std::abs(plane.signed_distance(point)) < gates.distance_m) {
        wall = part.wall;
      }
    }
  });
  return wall;
}

const KnownScene::Wall* KnownScene::wall_of(const PosedRibbon& ribbon,
                                            const AssociationGates& gates) const {
  const std::vector<Eigen::Vector3d> points = points_along(ribbon);
  std::size_t on_walls = 0;
  const Wall* wall = nullptr;
  for (const Eigen::Vector3d& point : points) {
    const auto found = wall_at(point, ribbon, gates);
    if (!found) continue;
    ++on_walls;
    wall = &walls_[*found];
  }
  return 2 * on_walls > points.size() ? wall : nullptr;
}

/// Returns how often a wall was seen at a point.
std::uint32_t KnownScene::points_at(const Eigen::Vector3d& point, std::uint32_t wall) const {
  const auto found = parts_.find(voxel_key(point, kVoxel_m));
  if (found == parts_.end()) return 0;
  for (const Part& part : found->second) {
    if (part.wall == wall) return part.points;
  }
  return 0;
}

bool KnownScene::is_pierced(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const {
  const auto found = parts_.find(voxel_key(point, kVoxel_m));
  if (found == parts_.end()) return false;
  return std::any_of(found->second.begin(), found->second.end(), [&](const Part& part) {
    const Hypothesis& wall = walls_[part.wall].plane;
    const double cosine = -wall.normal().dot(direction);
    if (part.points < kMinPoints || cosine < kMinCosineOfSide ||
        std::abs(wall.signed_distance(point)) > 0.25 * kVoxel_m * cosine) {
      return false;
    }
    // Beside a door, the frame's part of a voxel is not open.
    const Eigen::Vector3d beside = kVoxel_m * Eigen::Vector3d::UnitZ().cross(wall.normal());
    return points_at(point + beside, part.wall) >= kMinPoints &&
           points_at(point - beside, part.wall) >= kMinPoints;
  });
}

bool KnownScene::stands_between(const Eigen::Vector3d& sensor, const Eigen::Vector3d& point) const {
  const double distance = (point - sensor).norm();
  const Eigen::Vector3d direction = (point - sensor) / distance;
  for (double s = 0.5 * kVoxel_m; s < distance - kClearance_m; s += 0.5 * kVoxel_m) {
    if (is_pierced(sensor + s * direction, direction)) return true;
  }
  return false;
}

}  // namespace ribbon_mapper::slam
