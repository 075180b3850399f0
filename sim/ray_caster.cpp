// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ray_caster.hpp"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btOptimizedBvh.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include <Eigen/Geometry>

namespace ribbon_mapper::sim {
namespace {

/// Barycentric slack: no ray slips through the common edge of two triangles.
constexpr double kEdgeSlack = 1e-9;

/// Large triangles make poor trees: the boxes are those of pieces with edges up to this long. A ray
/// is intersected with the whole triangle all the same.
constexpr double kMaxPieceEdge_m = 3.0;

/// A triangle as the intersection needs it.
struct Facet {
  Eigen::Vector3d corner, edge_1, edge_2;
  int face;
};

btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

using Corners = std::array<Eigen::Vector3d, 3>;

/// Halves the longest edge until it is short enough.
template <typename Visitor>
void for_each_piece(const Corners& corners, const Visitor& visit) {
  int longest = 0;
  const auto edge_m = [&](int i) { return (corners[(i + 1) % 3] - corners[i]).norm(); };
  for (const int i : {1, 2})
    if (edge_m(i) > edge_m(longest)) longest = i;
  if (edge_m(longest) <= kMaxPieceEdge_m) return visit(corners);
  const Eigen::Vector3d &from = corners[longest], &to = corners[(longest + 1) % 3];
  const Eigen::Vector3d &opposite = corners[(longest + 2) % 3], middle = (from + to) / 2.0;
  for_each_piece(Corners{from, middle, opposite}, visit);
  for_each_piece(Corners{middle, to, opposite}, visit);
}

/// Keeps the nearest facet of those whose boxes the ray meets.
class NearestFacet : public btNodeOverlapCallback {
 public:
  NearestFacet(const std::vector<Facet>& facets, const Eigen::Vector3d& origin,
               const Eigen::Vector3d& direction, double max_range_m)
      : facets_(facets), origin_(origin), direction_(direction), nearest_{max_range_m, -1} {}

  void processNode(int /*part*/, int triangle) override {
    const Facet& facet = facets_[triangle];
    const Eigen::Vector3d p = direction_.cross(facet.edge_2);
    const double determinant = facet.edge_1.dot(p);
    if (determinant == 0.0) return;
    const double inverse = 1.0 / determinant;
    const Eigen::Vector3d s = origin_ - facet.corner;
    const double u = s.dot(p) * inverse;
    if (u < -kEdgeSlack || u > 1.0 + kEdgeSlack) return;
    const Eigen::Vector3d q = s.cross(facet.edge_1);
    const double v = direction_.dot(q) * inverse;
    if (v < -kEdgeSlack || u + v > 1.0 + kEdgeSlack) return;
    const double range_m = facet.edge_2.dot(q) * inverse;
    if (range_m > 0.0 && range_m < nearest_.range_m) nearest_ = {range_m, facet.face};
  }

  const Hit& nearest() const { return nearest_; }

 private:
  const std::vector<Facet>& facets_;
  const Eigen::Vector3d origin_, direction_;
  Hit nearest_;
};

}  // namespace

struct RayCaster::Tree {
  std::vector<btScalar> vertices;
  std::vector<int> indices;
  std::vector<Facet> facets;  ///< one for each piece
  std::unique_ptr<btTriangleIndexVertexArray> array;
  std::unique_ptr<btBvhTriangleMeshShape> shape;
};

RayCaster::RayCaster(const std::vector<Triangle>& triangles) : tree_(std::make_unique<Tree>()) {
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corners_m;
    const Facet facet{a, b - a, c - a, triangle.face};
    for_each_piece(triangle.corners_m, [&](const Corners& piece) {
      tree_->facets.push_back(facet);
      for (const Eigen::Vector3d& corner : piece) {
        tree_->indices.push_back(static_cast<int>(tree_->indices.size()));
        tree_->vertices.insert(tree_->vertices.end(), corner.data(), corner.data() + 3);
      }
    });
  }
  tree_->array = std::make_unique<btTriangleIndexVertexArray>(
      static_cast<int>(tree_->facets.size()), tree_->indices.data(), 3 * sizeof(int),
      static_cast<int>(tree_->indices.size()), tree_->vertices.data(), 3 * sizeof(btScalar));
  tree_->shape = std::make_unique<btBvhTriangleMeshShape>(tree_->array.get(), true);
}

RayCaster::~RayCaster() = default;

std::optional<Hit> RayCaster::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                   double max_range_m) const {
  NearestFacet callback(tree_->facets, origin, direction, max_range_m);
  tree_->shape->getOptimizedBvh()->reportRayOverlappingNodex(
      &callback, to_bullet(origin), to_bullet(origin + max_range_m * direction));
  if (callback.nearest().face < 0) return std::nullopt;
  return callback.nearest();
}

}  // namespace ribbon_mapper::sim
