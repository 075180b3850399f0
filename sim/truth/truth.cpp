// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth/truth.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "sim/truth/hit_grid.hpp"
#include "sim/truth/truth_patches.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

constexpr double kCell_m = 0.05;
constexpr double kMaxGap_m = 1.0;
constexpr double kMaxTopGap_m = 0.3;          // on table tops and the like: not bridged by lines
constexpr double kTopHeight_m = 0.2;          // above the ground: no robot drives there
constexpr double kTopCosine = 0.98480775301;  // cosine of 10 degrees
constexpr double kSameNormalCosine = 0.99996192;  // cosine of 0.5 degrees
constexpr double kSameOffset_m = 0.01;

/// One side of all world faces that lie in one plane, and its cells that beams hit.
struct Group {
  Vector3d normal;
  double d_m;
  Vector3d u_axis, v_axis;
  HitGrid hits;
  double least_height_m = std::numeric_limits<double>::infinity();  // above the ground

  Group(const Vector3d& normal_, double d) : normal(normal_), d_m(d) {
    const Vector3d level = normal.cross(Vector3d::UnitZ());
    u_axis = level.norm() > 0.1 ? level.normalized() : Vector3d::UnitX();
    u_axis = (u_axis - u_axis.dot(normal) * normal).normalized();
    v_axis = normal.cross(u_axis);
  }

  /// Adds a hit and returns the number of its cell, which is `next_number` at its first hit.
  int add(const Vector3d& point, int face, double ground_m, int next_number) {
    least_height_m = std::min(least_height_m, point.z() - ground_m);
    const auto u = static_cast<std::int32_t>(std::floor(point.dot(u_axis) / kCell_m));
    const auto v = static_cast<std::int32_t>(std::floor(point.dot(v_axis) / kCell_m));
    return hits.add(u, v, face, next_number);
  }

  Vector3d centre(const HitCell& cell) const {
    return (cell.u + 0.5) * kCell_m * u_axis + (cell.v + 0.5) * kCell_m * v_axis - d_m * normal;
  }

  bool holds(const Vector3d& other_normal, double other_d_m) const {
    return normal.dot(other_normal) > kSameNormalCosine &&
           std::abs(d_m - other_d_m) < kSameOffset_m;
  }

  TruthPlane plane(const std::vector<HitCell>& patch) const {
    TruthPlane plane;
    plane.normal = normal;
    plane.d_m = d_m;
    plane.axis_u = u_axis;
    plane.area_m2 = static_cast<double>(patch.size()) * kCell_m * kCell_m;
    std::set<int> faces;
    for (const HitCell& cell : patch) {
      plane.cells.push_back(centre(cell));
      plane.cell_numbers.push_back(cell.number);
      faces.insert(cell.face);
    }
    plane.faces.assign(faces.begin(), faces.end());
    return plane;
  }

  std::vector<std::vector<HitCell>> patches(double min_cells) const {
    auto patches = linked_patches(hits.cells(), kMaxGap_m / kCell_m);
    if (normal.z() < kTopCosine || least_height_m < kTopHeight_m) return patches;
    std::vector<std::vector<HitCell>> tops;
    for (const std::vector<HitCell>& patch : patches) {
      for (auto& top : divided(patch, kMaxTopGap_m / kCell_m, min_cells))
        tops.push_back(std::move(top));
    }
    return tops;
  }
};

}  // namespace

struct TruthCollector::State {
  const World& world;
  std::vector<Group> groups;
  std::vector<int> outer, inner;  ///< group by face, seen from its normal's side and from behind
  int cell_count = 0;

  int group_of(const Vector3d& normal, double d_m) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (groups[i].holds(normal, d_m)) return static_cast<int>(i);
    groups.emplace_back(normal, d_m);
    return static_cast<int>(groups.size()) - 1;
  }

  std::vector<TruthPlane> planes(double min_area_m2) const {
    std::vector<TruthPlane> planes;
    const double min_cells = (min_area_m2 - 1e-9) / (kCell_m * kCell_m);
    for (const Group& group : groups)
      for (const auto& patch : group.patches(min_cells))
        if (static_cast<double>(patch.size()) >= min_cells) planes.push_back(group.plane(patch));
    std::stable_sort(planes.begin(), planes.end(), [](const TruthPlane& a, const TruthPlane& b) {
      return a.cells.size() > b.cells.size();
    });
    for (std::size_t i = 0; i < planes.size(); ++i) planes[i].id = static_cast<int>(i);
    return planes;
  }
};

TruthCollector::TruthCollector(const World& world) : state_(new State{world, {}, {}, {}, 0}) {
  for (const Face& face : world.faces()) {
    state_->outer.push_back(face.planar ? state_->group_of(face.normal, face.d_m) : -1);
    state_->inner.push_back(face.planar ? state_->group_of(-face.normal, -face.d_m) : -1);
  }
}

TruthCollector::~TruthCollector() = default;

int TruthCollector::add(const Vector3d& point_map, const Vector3d& origin_map, int face,
                        double ground_m) {
  if (face < 0 || !state_->world.faces()[face].planar) return -1;
  const Face& hit = state_->world.faces()[face];
  const bool from_outside = hit.normal.dot(origin_map) + hit.d_m >= 0.0;
  Group& group = state_->groups[from_outside ? state_->outer[face] : state_->inner[face]];
  const int number = group.add(point_map, face, ground_m, state_->cell_count);
  state_->cell_count += number == state_->cell_count ? 1 : 0;
  return number;
}

std::vector<int> TruthCollector::add(const Scan& scan) {
  std::vector<int> numbers(scan.faces.size(), -1);
  for (std::size_t i = 0; i < scan.faces.size(); ++i) {
    if (scan.faces[i] < 0) continue;
    const Ray& ray = scan.rays[i];
    numbers[i] = add(ray.origin + scan.true_ranges_m[i] * ray.direction, ray.origin, scan.faces[i],
                     scan.ground_m);
  }
  return numbers;
}

std::vector<TruthPlane> TruthCollector::planes(double min_area_m2) const {
  return state_->planes(min_area_m2);
}

std::vector<TruthCell> TruthCollector::cells() const {
  std::vector<TruthCell> cells;
  for (const Group& group : state_->groups) {
    for (const HitCell& hit : group.hits.cells()) {
      cells.push_back({group.centre(hit), group.normal, hit.face});
    }
  }
  return cells;
}

}  // namespace ribbon_mapper::sim
