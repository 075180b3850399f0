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

/// A triangle as the intersection needs it.
struct Facet {
  Eigen::Vector3d corner, edge_1, edge_2;
  int face;
};

btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

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
  std::vector<Facet> facets;
  std::unique_ptr<btTriangleIndexVertexArray> array;
  std::unique_ptr<btBvhTriangleMeshShape> shape;
};

RayCaster::RayCaster(const std::vector<Triangle>& triangles) : tree_(std::make_unique<Tree>()) {
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corners_m;
    tree_->facets.push_back({a, b - a, c - a, triangle.face});
    for (const Eigen::Vector3d& corner : triangle.corners_m) {
      tree_->indices.push_back(static_cast<int>(tree_->indices.size()));
      tree_->vertices.insert(tree_->vertices.end(), corner.data(), corner.data() + 3);
    }
  }
  tree_->array = std::make_unique<btTriangleIndexVertexArray>(
      static_cast<int>(triangles.size()), tree_->indices.data(), 3 * sizeof(int),
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
