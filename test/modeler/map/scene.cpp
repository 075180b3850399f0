// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/modeler/map/scene.hpp"

#include <cmath>

namespace ribbon_mapper::mini_world {
namespace {

constexpr double spacing_m = 0.01, line_step_m = 0.02;
constexpr int points_per_sample = 3;

}  // namespace

Ribbon ribbon_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      const Eigen::Vector3d& normal) {
  Ribbon ribbon;
  ribbon.normal = normal.normalized();
  ribbon.length_m = (to - from).norm();
  ribbon.along = (to - from) / ribbon.length_m;
  const int points = static_cast<int>(std::lround(ribbon.length_m / spacing_m)) + 1;
  ribbon.last_beam = points - 1;
  ribbon.area_m2 = points * spacing_m * line_step_m;
  for (int begin = 0; begin < points; begin += points_per_sample) {
    RibbonSample sample;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = begin; i < std::min(points, begin + points_per_sample); ++i) {
      const Eigen::Vector3d p = from + (to - from) * (i / (points - 1.0));
      ribbon.moments.add(p);
      sum += p;
      ++sample.count;
    }
    sample.point = (sum / sample.count).cast<float>();
    ribbon.samples.push_back(sample);
  }
  ribbon.moments.spread(line_step_m * ribbon.normal.cross(ribbon.along));
  return ribbon;
}

std::vector<Ribbon> patch(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                          const Eigen::Vector3d& v) {
  std::vector<Ribbon> ribbons;
  const int steps = static_cast<int>(std::lround(v.norm() / 0.04));
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector3d from = corner + v * (static_cast<double>(i) / steps);
    ribbons.push_back(ribbon_between(from, from + u, u.cross(v)));
  }
  return ribbons;
}

PlaneMap Scene::map(const AssociationGates& gates, std::int64_t first_id) const {
  PlaneMap map(PlaneMapConfig{}, gates, first_id);
  for (std::uint32_t i = 0; i < ribbons.size(); ++i) map.add(evidence().ribbon(i), i);
  return map;
}

Hypothesis Scene::whole() const {
  Hypothesis hypothesis(0);
  for (std::uint32_t i = 0; i < ribbons.size(); ++i) {
    hypothesis.add(evidence().ribbon(i), {i, 1.0F});
  }
  return hypothesis;
}

Plane level_plane(double z_m, const std::vector<PlaneCell>& cells) {
  Plane plane;
  plane.d_m = -z_m;
  plane.origin = {0.0, 0.0, z_m};
  plane.cells = cells;
  plane.area_m2 = cells.size() * plane.cell_size_m * plane.cell_size_m;
  for (const PlaneCell& cell : cells) plane.centroid += cell_centre(plane, cell) / cells.size();
  return plane;
}

std::vector<PlaneCell> rectangle(int columns, int rows, int u0, int v0) {
  std::vector<PlaneCell> cells;
  for (int v = v0; v < v0 + rows; ++v) {
    for (int u = u0; u < u0 + columns; ++u) cells.push_back({u, v, 1, 0.0F, 0.0F});
  }
  return cells;
}

}  // namespace ribbon_mapper::mini_world
