// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/bevel.hpp"

#include <algorithm>
#include <numeric>

#include "modeler/map/footprint.hpp"

namespace ribbon_mapper {
namespace {

/// A plane that others may lie on.
class Ground {
 public:
  Ground(const Plane& plane, const PlaneMapConfig& config)
      : plane_(&plane),
        on_plane_m_(config.on_plane_m),
        beside_(plane, config.beside_plane_m),
        beyond_gap_(plane, 0.5 * config.bridged_gap_m) {}

  /// True for a cell of `other` that lies on this plane, as measured.
  bool explains(const Plane& other, const PlaneCell& cell) const {
    const double cosine = plane_->normal.dot(other.normal);
    if (cosine <= 0.0) return false;  // the back of a thin wall is no part of its front
    const Footprint& footprint = cosine > least_cosine_of_splinter ? beyond_gap_ : beside_;
    return footprint.holds(cell_centre(other, cell) + cell.mean_m * other.normal, on_plane_m_);
  }

 private:
  static constexpr double least_cosine_of_splinter = 0.985;  // 10 degrees

  const Plane* plane_;
  double on_plane_m_;
  Footprint beside_, beyond_gap_;
};

bool is_bevel(const Plane& plane, const std::vector<Ground>& larger) {
  std::size_t explained = 0;
  for (const PlaneCell& cell : plane.cells) {
    explained += std::any_of(larger.begin(), larger.end(),
                             [&](const Ground& ground) { return ground.explains(plane, cell); });
  }
  return 2 * explained > plane.cells.size();
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
