// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/bevel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace ribbon_mapper {
namespace {

/// Where on a plane there are cells, in blocks as wide as the reach.
class Footprint {
 public:
  Footprint(const Plane& plane, double reach_m) : plane_(plane), reach_m_(reach_m) {
    for (const PlaneCell& cell : plane.cells) {
      blocks_.insert(block_at((cell.u + 0.5) * plane.cell_size_m,
                              (cell.v + 0.5) * plane.cell_size_m, 0, 0));
    }
  }

  /// The back of a thin wall is no part of its front.
  bool faces(const Plane& other) const { return plane_.normal.dot(other.normal) > 0.0; }

  bool holds(const Eigen::Vector3d& point, double tolerance_m) const {
    if (std::abs(plane_.normal.dot(point) + plane_.d_m) > tolerance_m) return false;
    const Eigen::Vector3d place = point - plane_.origin;
    const double u_m = place.dot(plane_.axis_u), v_m = place.dot(plane_.axis_v);
    for (int du = -1; du <= 1; ++du) {
      for (int dv = -1; dv <= 1; ++dv) {
        if (blocks_.count(block_at(u_m, v_m, du, dv))) return true;
      }
    }
    return false;
  }

 private:
  std::int64_t block_at(double u_m, double v_m, int du, int dv) const {
    const auto u = static_cast<std::int64_t>(std::floor(u_m / reach_m_)) + du;
    const auto v = static_cast<std::int64_t>(std::floor(v_m / reach_m_)) + dv;
    return u * (std::int64_t{1} << 32) + v;
  }

  const Plane& plane_;
  double reach_m_;
  std::unordered_set<std::int64_t> blocks_;
};

bool is_bevel(const Plane& plane, const std::vector<Footprint>& larger,
              const PlaneMapConfig& config) {
  std::size_t explained = 0;
  for (const PlaneCell& cell : plane.cells) {
    const Eigen::Vector3d point = cell_centre(plane, cell) + cell.mean_m * plane.normal;
    explained += std::any_of(larger.begin(), larger.end(), [&](const Footprint& footprint) {
      return footprint.faces(plane) && footprint.holds(point, config.bevel_tolerance_m);
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
    footprints.emplace_back(kept.back(), config.bevel_reach_m);
  }
  return kept;
}

}  // namespace ribbon_mapper
