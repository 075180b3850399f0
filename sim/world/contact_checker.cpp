// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/contact_checker.hpp"

#include <btBulletCollisionCommon.h>

#include <Eigen/Geometry>
#include <cmath>

namespace ribbon_mapper::sim {
namespace {

constexpr double kTouch_m = 1e-6;  // shapes that overlap by less only touch
constexpr double kPi = 3.14159265358979323846;

btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

btTransform to_bullet(const Pose& pose) {
  const Eigen::Matrix3d m = pose.linear();
  const btMatrix3x3 rotation(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1),
                             m(2, 2));
  return btTransform(rotation, to_bullet(Eigen::Vector3d(pose.translation())));
}

std::unique_ptr<btTriangleMesh> triangles_of(const MeshShape& mesh) {
  auto triangles = std::make_unique<btTriangleMesh>();
  for (const auto& [a, b, c] : mesh.triangles)
    triangles->addTriangle(to_bullet(mesh.vertices_m[a]), to_bullet(mesh.vertices_m[b]),
                           to_bullet(mesh.vertices_m[c]));
  return triangles;
}

/// Returns true if the mesh encloses `point`. Sums the solid angles of the triangles as seen from
/// there (Van Oosterom and Strackee 1983): a full sphere inside a closed mesh, zero outside.
bool encloses(const MeshShape& mesh, const Eigen::Vector3d& point) {
  double half_angles = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices_m[triangle[0]] - point;
    const Eigen::Vector3d b = mesh.vertices_m[triangle[1]] - point;
    const Eigen::Vector3d c = mesh.vertices_m[triangle[2]] - point;
    half_angles +=
        std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                          b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return std::abs(half_angles) > kPi;
}

/// Keeps the deepest contact.
struct DeepestContact : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    if (point.getDistance() >= distance_m) return 0;
    distance_m = point.getDistance();
    shape =
        std::max(a->getCollisionObject()->getUserIndex(), b->getCollisionObject()->getUserIndex());
    return 0;
  }
  double distance_m = -kTouch_m;
  int shape = -1;
};

}  // namespace

struct ContactChecker::Scene {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
  std::vector<std::unique_ptr<btTriangleMesh>> meshes;
  std::vector<std::unique_ptr<btCollisionShape>> bullet_shapes;
  std::vector<std::unique_ptr<btCollisionObject>> objects;
  std::vector<Shape> shapes;

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
    meshes.push_back(triangles_of(mesh));
    auto shape = std::make_unique<btBvhTriangleMeshShape>(meshes.back().get(), true);
    shape->setMargin(0.0);
    return shape;
  }

  void add(const Shape& shape) {
    bullet_shapes.push_back(
        std::visit([this](const auto& geometry) { return made(geometry); }, shape.geometry));
    objects.push_back(std::make_unique<btCollisionObject>());
    objects.back()->setCollisionShape(bullet_shapes.back().get());
    objects.back()->setWorldTransform(to_bullet(shape.T_map_shape));
    objects.back()->setUserIndex(static_cast<int>(shapes.size()));
    shapes.push_back(shape);
    world.addCollisionObject(objects.back().get());
  }
};

ContactChecker::ContactChecker(const std::vector<Shape>& shapes)
    : scene_(std::make_unique<Scene>()) {
  for (const Shape& shape : shapes) scene_->add(shape);
}

ContactChecker::~ContactChecker() = default;

std::optional<std::string> ContactChecker::contact(const Pose& T_map_box,
                                                   const Eigen::Vector3d& size_m) {
  btBoxShape box(to_bullet(Eigen::Vector3d(size_m / 2.0)));
  btCollisionObject object;
  object.setCollisionShape(&box);
  object.setWorldTransform(to_bullet(T_map_box));
  object.setUserIndex(-1);
  DeepestContact deepest;
  scene_->world.contactTest(&object, deepest);
  if (deepest.shape >= 0) return scene_->shapes[deepest.shape].name;
  for (const Shape& shape : scene_->shapes) {
    const auto* mesh = std::get_if<MeshShape>(&shape.geometry);
    if (mesh &&
        encloses(*mesh, shape.T_map_shape.inverse() * Eigen::Vector3d(T_map_box.translation())))
      return shape.name;
  }
  return std::nullopt;
}

}  // namespace ribbon_mapper::sim
