// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/bevel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "modeler/map/footprint.hpp"

namespace ribbon_mapper {
namespace {

/// Where the points of a cell were, on average.
Eigen::Vector3d measured(const Plane& plane, const PlaneCell& cell) {
  return cell_centre(plane, cell) + cell.mean_m * plane.normal;
}

/// Around all of these points.
Eigen::AlignedBox3d box_of(const Plane& plane) {
  Eigen::AlignedBox2i grid;
  float most_m = 0.0F;
  for (const PlaneCell& cell : plane.cells) {
    grid.extend(Eigen::Vector2i(cell.u, cell.v));
    most_m = std::max(most_m, std::abs(cell.mean_m));
  }
  Eigen::AlignedBox3d box;
  for (const int u : {grid.min().x(), grid.max().x() + 1}) {
    for (const int v : {grid.min().y(), grid.max().y() + 1}) {
      const Eigen::Vector3d corner = grid_corner(plane, u, v);
      box.extend(corner + most_m * plane.normal);
      box.extend(corner - most_m * plane.normal);
    }
  }
  return box;
}

/// A plane that others may lie on.
class Ground {
 public:
  Ground(const Plane& plane, const PlaneMapConfig& config)
      : plane_(&plane), config_(&config), box_(box_of(plane)) {
    const double margin_m = config.bridged_gap_m + config.on_plane_m;  // twice the wider reach
    box_.min().array() -= margin_m;
    box_.max().array() += margin_m;
  }

  bool is_near(const Eigen::AlignedBox3d& box) const { return box_.intersects(box); }

  /// Marks the cells of `other` that lie on this plane, as measured.
  void explain(const Plane& other, std::vector<bool>& explained) {
    const double cosine = plane_->normal.dot(other.normal);
    if (cosine <= 0.0) return;  // the back of a thin wall is no part of its front
    const bool is_splinter = cosine > least_cosine_of_splinter;
    for (std::size_t i = 0; i < explained.size(); ++i) {
      if (explained[i]) continue;
      const Eigen::Vector3d point = measured(other, other.cells[i]);
      if (std::abs(plane_->normal.dot(point) + plane_->d_m) > config_->on_plane_m) continue;
      const Footprint& around = is_splinter ? footprint(beyond_gap_, 0.5 * config_->bridged_gap_m)
                                            : footprint(beside_, config_->beside_plane_m);
      explained[i] = around.holds(point, config_->on_plane_m);
    }
  }

 private:
  static constexpr double least_cosine_of_splinter = 0.985;  // 10 degrees

  /// Made when it is first asked for.
  const Footprint& footprint(std::optional<Footprint>& made, double reach_m) {
    if (!made) made.emplace(*plane_, reach_m);
    return *made;
  }

  const Plane* plane_;
  const PlaneMapConfig* config_;
  Eigen::AlignedBox3d box_;
  std::optional<Footprint> beside_, beyond_gap_;
};

bool is_bevel(const Plane& plane, std::vector<Ground>& larger) {
  if (plane.cells.empty()) return false;
  const Eigen::AlignedBox3d box = box_of(plane);
  std::vector<bool> explained(plane.cells.size(), false);
  for (Ground& ground : larger) {
    if (ground.is_near(box)) ground.explain(plane, explained);
  }
  const auto count = std::count(explained.begin(), explained.end(), true);
  return 2 * static_cast<std::size_t>(count) > plane.cells.size();
}

}  // namespace

std::vector<bool> are_bevels(const std::vector<const Plane*>& planes,
                             const PlaneMapConfig& config) {
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return planes[a]->area_m2 > planes[b]->area_m2;
  });
  std::vector<bool> bevels(planes.size());
  std::vector<Ground> larger;
  for (const std::size_t i : order) {
    bevels[i] = is_bevel(*planes[i], larger);
    if (!bevels[i]) larger.emplace_back(*planes[i], config);
  }
  return bevels;
}

std::vector<Plane> without_bevels(std::vector<Plane> planes, const PlaneMapConfig& config) {
  std::stable_sort(planes.begin(), planes.end(),
                   [](const Plane& a, const Plane& b) { return a.area_m2 > b.area_m2; });
  std::vector<const Plane*> pointers;
  for (const Plane& plane : planes) pointers.push_back(&plane);
  const std::vector<bool> bevels = are_bevels(pointers, config);
  std::vector<Plane> kept;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!bevels[i]) kept.push_back(std::move(planes[i]));
  }
  return kept;
}

}  // namespace ribbon_mapper
