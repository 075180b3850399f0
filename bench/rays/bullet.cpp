// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <btBulletCollisionCommon.h>

#include <Eigen/Geometry>
#include <limits>

#include "bench/rays/rays_peer.hpp"

namespace ribbon_mapper::bench {
namespace {

using namespace sim;

btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

btTransform to_bullet(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()),
                     to_bullet(Eigen::Vector3d(pose.translation())));
}

/// The world as Bullet's examples set it up: one collision object for each shape.
struct Scene {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
  std::vector<std::unique_ptr<btTriangleMesh>> meshes;
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btCollisionObject>> objects;

  ~Scene() {
    for (const auto& object : objects) world.removeCollisionObject(object.get());
  }
  std::unique_ptr<btCollisionShape> made(const BoxShape& box) {
    return std::make_unique<btBoxShape>(to_bullet(Eigen::Vector3d(box.size_m / 2.0)));
  }
  std::unique_ptr<btCollisionShape> made(const CylinderShape& cylinder) {
    return std::make_unique<btCylinderShapeZ>(
        btVector3(cylinder.radius_m, cylinder.radius_m, cylinder.length_m / 2.0));
  }
  std::unique_ptr<btCollisionShape> made(const SphereShape& sphere) {
    return std::make_unique<btSphereShape>(sphere.radius_m);
  }
  std::unique_ptr<btCollisionShape> made(const PlaneShape& plane) {
    return std::make_unique<btStaticPlaneShape>(to_bullet(plane.normal.normalized().eval()), 0.0);
  }
  std::unique_ptr<btCollisionShape> made(const MeshShape& mesh) {
    meshes.push_back(std::make_unique<btTriangleMesh>());
    for (const auto& [a, b, c] : mesh.triangles) {
      meshes.back()->addTriangle(to_bullet(mesh.vertices_m[a]), to_bullet(mesh.vertices_m[b]),
                                 to_bullet(mesh.vertices_m[c]));
    }
    return std::make_unique<btBvhTriangleMeshShape>(meshes.back().get(), true);
  }
  void add(const Shape& shape) {
    shapes.push_back(
        std::visit([this](const auto& geometry) { return made(geometry); }, shape.geometry));
    objects.push_back(std::make_unique<btCollisionObject>());
    objects.back()->setCollisionShape(shapes.back().get());
    objects.back()->setWorldTransform(to_bullet(shape.T_map_shape));
    world.addCollisionObject(objects.back().get());
  }
};

}  // namespace

RayCasting bullet_ray_test(const std::vector<Shape>& shapes) {
  auto scene = std::make_shared<Scene>();
  for (const Shape& shape : shapes) scene->add(shape);
  scene->world.updateAabbs();
  return [scene](const std::vector<Ray>& rays, double max_range_m, std::vector<float>& ranges) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const btVector3 from = to_bullet(rays[i].origin);
      const btVector3 to =
          to_bullet(Eigen::Vector3d(rays[i].origin + max_range_m * rays[i].direction));
      btCollisionWorld::ClosestRayResultCallback callback(from, to);
      scene->world.rayTest(from, to, callback);
      ranges[i] = callback.hasHit()
                      ? static_cast<float>(callback.m_closestHitFraction * max_range_m)
                      : std::numeric_limits<float>::infinity();
    }
  };
}

}  // namespace ribbon_mapper::bench
