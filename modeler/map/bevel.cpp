// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/bevel.hpp"

#include <algorithm>

#include "modeler/map/footprint.hpp"

namespace ribbon_mapper {
namespace {

bool is_bevel(const Plane& plane, const std::vector<Footprint>& larger,
              const PlaneMapConfig& config) {
  std::size_t explained = 0;
  for (const PlaneCell& cell : plane.cells) {
    const Eigen::Vector3d point = cell_centre(plane, cell) + cell.mean_m * plane.normal;
    explained += std::any_of(larger.begin(), larger.end(), [&](const Footprint& footprint) {
      // The back of a thin wall is no part of its front.
      return footprint.plane().normal.dot(plane.normal) > 0.0 &&
             footprint.holds(point, config.on_plane_m);
    });
  }
  return 2 * explained > plane.cells.size();
}

}  // namespace

std::vector<Plane> without_bevels(std::vector<Plane> planes, const PlaneMapConfig& config) {
  std::stable_sort(planes.begin(), planes.end(),
                   [](const Plane& a, const Plane& b) { return a.area_m2 > b.area_m2; });
  std::vector<Plane> kept;
  kept.reserve(planes.size());  // footprints refer to them
  std::vector<Footprint> footprints;
  for (Plane& plane : planes) {
    if (is_bevel(plane, footprints, config)) continue;
    kept.push_back(std::move(plane));
    footprints.emplace_back(kept.back(), config.beside_plane_m);
  }
  return kept;
}

}  // namespace ribbon_mapper
