// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kCosine = 0.9999996192;  // cosine of 0.05 degrees
constexpr double kOffset_m = 0.0001;
constexpr double kWeld_m = 1e-5;  // exporters repeat a corner for each triangle

using VertexKey = std::tuple<long, long, long>;
using Edge = std::pair<int, int>;

std::vector<int> welded_vertices(const MeshShape& mesh) {
  std::map<VertexKey, int> ids;
  std::vector<int> welded;
  for (const Eigen::Vector3d& p : mesh.vertices_m) {
    const VertexKey key{std::lround(p.x() / kWeld_m), std::lround(p.y() / kWeld_m),
                        std::lround(p.z() / kWeld_m)};
    welded.push_back(ids.emplace(key, static_cast<int>(ids.size())).first->second);
  }
  return welded;
}

std::map<Edge, std::vector<int>> triangles_by_edge(const MeshShape& mesh) {
  const std::vector<int> welded = welded_vertices(mesh);
  std::map<Edge, std::vector<int>> by_edge;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      by_edge[std::minmax({welded[mesh.triangles[t][i]], welded[mesh.triangles[t][(i + 1) % 3]]})]
          .push_back(static_cast<int>(t));
  return by_edge;
}

}  // namespace

std::vector<int> coplanar_patches(const MeshShape& mesh) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Eigen::Vector4d> planes(count);
  std::vector<std::vector<int>> neighbours(count);
  for (std::size_t t = 0; t < count; ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Eigen::Vector3d& p = mesh.vertices_m[a];
    const Eigen::Vector3d n = (mesh.vertices_m[b] - p).cross(mesh.vertices_m[c] - p).normalized();
    planes[t] << n, -n.dot(p);
  }
  for (const auto& [edge, sharing] : triangles_by_edge(mesh))
    for (const int t : sharing)
      for (const int other : sharing)
        if (t != other) neighbours[t].push_back(other);

  std::vector<int> patches(count, -1);
  int patch = 0;
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (patches[seed] >= 0) continue;
    std::vector<int> open{static_cast<int>(seed)};
    patches[seed] = patch;
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      for (const int n : neighbours[t]) {
        const bool same =
            planes[n].head<3>().dot(planes[seed].head<3>()) > kCosine &&
            std::abs(planes[n].head<3>().dot(mesh.vertices_m[mesh.triangles[seed][0]]) +
                     planes[n].w()) < kOffset_m;
        if (patches[n] >= 0 || !same) continue;
        patches[n] = patch;
        open.push_back(n);
      }
    }
    ++patch;
  }
  return patches;
}

}  // namespace ribbon_mapper::sim
