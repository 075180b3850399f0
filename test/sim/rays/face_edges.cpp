// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/sim/rays/face_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;
using Corner = std::tuple<long, long, long>;

constexpr double kSameCorner_m = 1e-6;
constexpr double kFlat = 1e-6;  ///< 1 - cosine between coplanar triangles: below 0.08 degrees

Corner corner_of(const Vector3d& p) {
  return {std::lround(p.x() / kSameCorner_m), std::lround(p.y() / kSameCorner_m),
          std::lround(p.z() / kSameCorner_m)};
}

Vector3d normal_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners_m;
  return (b - a).cross(c - a).normalized();
}

}  // namespace

FaceEdges::FaceEdges(const World& world) : edges_(world.faces().size()) {
  struct Side {
    Segment segment;
    std::vector<Vector3d> normals;
  };
  std::map<std::tuple<int, Corner, Corner>, Side> sides;
  for (const Triangle& triangle : world.triangles())
    for (int i = 0; i < 3; ++i) {
      const Vector3d &from = triangle.corners_m[i], &to = triangle.corners_m[(i + 1) % 3];
      const auto [low, high] = std::minmax({corner_of(from), corner_of(to)});
      Side& side = sides[{triangle.face, low, high}];
      side.segment = {from, to};
      side.normals.push_back(normal_of(triangle));
    }
  for (const auto& [key, side] : sides) {
    const bool is_inside =
        side.normals.size() == 2 && std::abs(side.normals[0].dot(side.normals[1])) > 1.0 - kFlat;
    if (!is_inside) edges_[std::get<0>(key)].push_back(side.segment);
  }
}

double FaceEdges::distance_m(const Vector3d& point_map, int face) const {
  double nearest_m = INFINITY;
  for (const auto& [from, to] : edges_[face]) {
    const Vector3d way = to - from, offset = point_map - from;
    const double share = std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0);
    nearest_m = std::min(nearest_m, (offset - share * way).norm());
  }
  return nearest_m;
}

}  // namespace ribbon_mapper::sim
