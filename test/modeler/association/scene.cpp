// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/modeler/association/scene.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/ribbon/packed_store.hpp"
#include "modeler/ribbon/sample_packer.hpp"

namespace ribbon_mapper::mini_world {
namespace {

constexpr double kSpacing_m = 0.01, kLineStep_m = 0.02;
constexpr std::size_t kPointsPerSample = 3;

}  // namespace

Ribbon ribbon_of(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal) {
  static PackedStore<PackedSample> store;  // outlives all ribbons
  const Eigen::Vector3d up = normal.normalized(), chord = points.back() - points.front();
  const Eigen::Vector3d along = (chord - up.dot(chord) * up).normalized();
  Moments moments;
  for (const Eigen::Vector3d& point : points) moments.add(point);
  const Eigen::Vector3d centroid = moments.mean();
  SamplePacker packer;
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsPerSample) {
    const std::size_t end = std::min(points.size(), begin + kPointsPerSample);
    Moments sample;
    for (std::size_t i = begin; i < end; ++i) sample.add(points[i] - centroid);
    packer.add(along.dot(sample.mean()), up.dot(sample.mean()),
               sample.mean_square_distance(up, 0.0), end - begin);
  }
  Ribbon ribbon;
  ribbon.normal = up.cast<float>();
  ribbon.along = along.cast<float>();
  ribbon.last_beam = static_cast<std::uint32_t>(points.size() - 1);
  ribbon.area_m2 = static_cast<float>(points.size() * kSpacing_m * kLineStep_m);
  moments.spread(kLineStep_m * up.cross(along));
  ribbon.moments = moments;
  ribbon.samples = packer.pack();
  ribbon.length_m = ribbon.samples.length_m();
  ribbon.samples.first = store.add(ribbon.samples.first, ribbon.samples.size);
  return ribbon;
}

Ribbon ribbon_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      const Eigen::Vector3d& normal) {
  const int steps = static_cast<int>(std::lround((to - from).norm() / kSpacing_m));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= steps; ++i) points.push_back(from + (to - from) * i / steps);
  return ribbon_of(points, normal);
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
  PlaneMap map(SurfaceConfig{}.bridged_gap_m, gates, first_id);
  for (std::uint32_t i = 0; i < ribbons.size(); ++i) map.add(observations().ribbon(i), i);
  return map;
}

Hypothesis Scene::whole() const {
  Hypothesis hypothesis(0);
  for (std::uint32_t i = 0; i < ribbons.size(); ++i) {
    hypothesis.add(observations().ribbon(i), {i, 1.0F});
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
