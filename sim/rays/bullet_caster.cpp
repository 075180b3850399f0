// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/bullet_caster.hpp"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

namespace ribbon_mapper::sim {
namespace {

constexpr bool kQuantised = false;  // quantised boxes cost accuracy and are slower here

btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Keeps the nearest triangle: Bullet reports only triangles nearer than the last one reported.
struct NearestTriangle : btTriangleRaycastCallback {
  using btTriangleRaycastCallback::btTriangleRaycastCallback;

  btScalar reportHit(const btVector3&, btScalar fraction, int, int index) override {
    triangle = index;
    return fraction;
  }

  int triangle = -1;
};

class BulletCaster : public RayCaster {
 public:
  explicit BulletCaster(const std::vector<Triangle>& triangles) {
    for (const Triangle& triangle : triangles) {
      const auto& [a, b, c] = triangle.corners_m;
      mesh_.addTriangle(to_bullet(a), to_bullet(b), to_bullet(c));
      faces_.push_back(triangle.face);
    }
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, kQuantised);
  }

  std::optional<Hit> cast(const Ray& ray, double max_range_m) const override {
    const btVector3 from = to_bullet(ray.origin);
    const btVector3 to = to_bullet(ray.origin + max_range_m * ray.direction);
    NearestTriangle nearest(from, to);
    shape_->performRaycast(&nearest, from, to);  // not const, but changes nothing
    if (nearest.triangle < 0) return std::nullopt;
    return Hit{nearest.m_hitFraction * max_range_m, faces_[nearest.triangle]};
  }

 private:
  btTriangleMesh mesh_;
  std::vector<int> faces_;  ///< by index of the triangle
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

}  // namespace

std::unique_ptr<const RayCaster> make_bullet_caster(const std::vector<Triangle>& triangles) {
  return std::make_unique<BulletCaster>(triangles);
}

}  // namespace ribbon_mapper::sim
