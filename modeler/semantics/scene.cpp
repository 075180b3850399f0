// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

constexpr std::size_t kLeastFootprints = 3;  // one may stand on an edge
constexpr double kLeastCeiling_m2 = 1.0;     // less is the underside of a thing
constexpr int kFloorRings = 4;               // a metre: floor under tables is not seen
constexpr double kSameSideCosine = 0.97;     // 14 degrees

}  // namespace

Scene::Scene(const std::vector<Plane>& planes, const std::vector<Eigen::Vector3d>& driven,
             const LabelConfig& config)
    : planes_(planes), config_(config), driven_(planes.size()), floor_(planes.size()) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    shapes_.push_back(shape_of(planes[i], config));
    const Attitude attitude = shapes_[i].attitude;
    if (attitude == Attitude::level_up || attitude == Attitude::tilted_up) {
      add(i, upward_);
    }
    if (attitude == Attitude::upright) add(i, upright_);
  }
  find_driven(driven);
  find_floors();
  find_ceilings();
}

void Scene::add(std::size_t plane, TopView<PlanePart>& view) const {
  for (const PlaneCell& cell : planes_[plane].cells) {
    const Eigen::Vector3d centre = cell_centre(planes_[plane], cell);
    std::vector<PlanePart>& parts = view.at(centre.head<2>());
    if (parts.empty() || parts.back().plane != plane) {
      parts.push_back({plane, centre.z(), centre.z()});
    }
    parts.back().lowest_m = std::min(parts.back().lowest_m, centre.z());
    parts.back().highest_m = std::max(parts.back().highest_m, centre.z());
  }
}

void Scene::find_driven(const std::vector<Eigen::Vector3d>& driven) {
  footprints_.assign(planes_.size(), 0);
  for (const Eigen::Vector3d& footprint : driven) {
    footprints_seen_.at(footprint.head<2>()).push_back(footprint);
    std::vector<std::size_t> below;
    upward_.for_each_around(footprint.head<2>(), 1, [&](const PlanePart& part) {
      const Plane& plane = planes_[part.plane];
      const double distance_m = plane.normal.dot(footprint) + plane.d_m;
      if (std::abs(distance_m) <= config_.floor_step_m) below.push_back(part.plane);
    });
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    for (const std::size_t plane : below) ++footprints_[plane];
  }
  for (std::size_t i = 0; i < planes_.size(); ++i) driven_[i] = footprints_[i] >= kLeastFootprints;
}

void Scene::find_floors() {
  const auto goes_first = [&](std::size_t a, std::size_t b) {
    if (footprints_[a] != footprints_[b]) return footprints_[a] > footprints_[b];
    return planes_[a].area_m2 > planes_[b].area_m2;
  };
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (shapes_[i].attitude != Attitude::level_up || planes_[i].cells.empty()) continue;
    if (!main_floor_ || goes_first(i, *main_floor_)) main_floor_ = i;
  }
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const bool is_low =
        main_floor_ &&
        planes_[i].centroid.z() <= planes_[*main_floor_].centroid.z() + config_.floor_step_m;
    floor_[i] = shapes_[i].attitude == Attitude::level_up && (is_low || driven_[i]);
    const bool carries = floor_[i] || (driven_[i] && shapes_[i].attitude == Attitude::tilted_up);
    if (!carries) continue;
    add(i, floors_);
    for (const PlaneCell& cell : planes_[i].cells) {
      const Eigen::Vector3d centre = cell_centre(planes_[i], cell);
      floor_cells_.at(centre.head<2>()).push_back(centre);
    }
  }
}

void Scene::find_ceilings() {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const Attitude attitude = shapes_[i].attitude;
    if (attitude != Attitude::level_down && attitude != Attitude::tilted_down) continue;
    const double clear_m = shapes_[i].highest_m - floor_height_m(planes_[i].centroid);
    if (planes_[i].area_m2 >= kLeastCeiling_m2 && clear_m >= config_.head_height_m) {
      add(i, overhead_);
    }
  }
}

double Scene::floor_height_m(const Eigen::Vector3d& point) const {
  std::optional<double> height_m;
  for (int rings = 1; rings <= kFloorRings && !height_m; ++rings) {
    floors_.for_each_around(point.head<2>(), rings, [&](const PlanePart& part) {
      const double z_m = part.highest_m;
      if (z_m <= point.z() + config_.floor_step_m && z_m > height_m.value_or(z_m - 1.0)) {
        height_m = z_m;
      }
    });
  }
  if (height_m) return *height_m;
  return main_floor_ ? planes_[*main_floor_].centroid.z() : 0.0;
}

std::optional<double> Scene::ceiling_height_m(const Eigen::Vector2d& place, double from_m) const {
  std::optional<double> height_m;
  overhead_.for_each_around(place, 1, [&](const PlanePart& part) {
    if (part.highest_m > from_m && part.lowest_m < height_m.value_or(part.lowest_m + 1.0)) {
      height_m = part.lowest_m;
    }
  });
  return height_m;
}

std::vector<Eigen::Vector3d> Scene::floor_cells_around(const Eigen::Vector2d& place,
                                                       double reach_m) const {
  std::vector<Eigen::Vector3d> cells;
  floor_cells_.for_each_around(place, static_cast<int>(std::ceil(reach_m / kSquare_m)),
                               [&](const Eigen::Vector3d& cell) { cells.push_back(cell); });
  return cells;
}

bool Scene::is_driven_at(const Eigen::Vector2d& place, double height_m, double reach_m) const {
  bool is_driven = false;
  footprints_seen_.for_each_around(
      place, static_cast<int>(std::ceil(reach_m / kSquare_m)), [&](const Eigen::Vector3d& at) {
        is_driven = is_driven || ((at.head<2>() - place).norm() <= reach_m &&
                                  std::abs(at.z() - height_m) <= config_.floor_step_m);
      });
  return is_driven;
}

std::vector<std::size_t> Scene::upright_around(const Eigen::Vector2d& place, double reach_m) const {
  std::vector<std::size_t> planes;
  upright_.for_each_around(place, static_cast<int>(std::ceil(reach_m / kSquare_m)),
                           [&](const PlanePart& part) { planes.push_back(part.plane); });
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  return planes;
}

double Scene::backed_share(std::size_t plane) const {
  const std::vector<Column>& columns = shapes_[plane].columns;
  const auto backed = std::count_if(columns.begin(), columns.end(),
                                    [&](const Column& column) { return is_backed(plane, column); });
  return static_cast<double>(backed) / static_cast<double>(columns.size());
}

bool Scene::is_backed(std::size_t plane, const Column& column) const {
  const Plane& front = planes_[plane];
  const Eigen::Vector2d back = -front.normal.head<2>().normalized();
  const Eigen::Vector3d place(column.place.x(), column.place.y(), front.centroid.z());
  bool is_backed = false;
  const auto look_at = [&](const PlanePart& part) {
    const Plane& other = planes_[part.plane];
    const double depth_m = other.normal.dot(place) + other.d_m;
    is_backed = is_backed ||
                (front.normal.dot(other.normal) >= kSameSideCosine &&
                 depth_m > config_.floor_step_m && depth_m <= config_.furniture_depth_m &&
                 shapes_[part.plane].highest_m >= shapes_[plane].highest_m + config_.rise_behind_m);
  };
  for (double depth_m = 0.0; depth_m <= config_.furniture_depth_m && !is_backed;
       depth_m += upright_.square_m()) {
    upright_.for_each_around(column.place + depth_m * back, 0, look_at);
  }
  return is_backed;
}

}  // namespace ribbon_mapper
