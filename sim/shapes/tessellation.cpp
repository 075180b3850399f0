// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/shapes/tessellation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

constexpr double kSagitta_m = 0.00019;
constexpr double kPlaneHalfSide_m = 100.0;
constexpr int kMostChords = 1440;  // a circle of 40 m; a larger sphere would take gigabytes
constexpr double kPi = 3.14159265358979323846;

/// Adds the faces and triangles of one shape, transformed to map.
class Builder {
 public:
  Builder(const Shape& shape, Tessellation& tessellation) : shape_(shape), out_(tessellation) {}

  void start_planar(const std::string& side, const Vector3d& normal, const Vector3d& point,
                    bool bounded = true) {
    const Vector3d n = shape_.T_map_shape.linear() * normal;
    out_.faces.push_back({shape_.name + "/" + side, n, -n.dot(shape_.T_map_shape * point), true,
                          bounded, shape_.label});
  }
  void start_curved(const std::string& side) {
    out_.faces.push_back(
        {shape_.name + "/" + side, Vector3d::UnitZ(), 0.0, false, true, shape_.label});
  }
  void triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Pose& T = shape_.T_map_shape;
    out_.triangles.push_back({{T * a, T * b, T * c}, static_cast<int>(out_.faces.size()) - 1});
  }
  void quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

 private:
  const Shape& shape_;
  Tessellation& out_;
};

/// Returns how many chords approximate a circle with a sagitta below `sagitta_m`.
int chord_count(double radius_m, double sagitta_m) {
  const double half_angle_rad = std::acos(std::max(0.0, 1.0 - sagitta_m / radius_m));
  return static_cast<int>(std::clamp(std::ceil(kPi / half_angle_rad), 12.0, 1.0 * kMostChords));
}

Vector3d on_circle(double radius_m, int step, int steps, double z_m) {
  const double angle_rad = 2.0 * kPi * (step % steps) / steps;
  return {radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad), z_m};
}

void add(const BoxShape& box, Builder& builder) {
  static const std::array<std::string, 6> kSides{"+x", "+y", "+z", "-x", "-y", "-z"};
  for (int side = 0; side < 6; ++side) {
    const int axis = side % 3;
    const double sign = side < 3 ? 1.0 : -1.0;
    const Vector3d normal = sign * Vector3d::Unit(axis);
    const Vector3d half = box.size_m / 2.0;
    const Vector3d centre = normal * half[axis];
    const Vector3d u = Vector3d::Unit((axis + 1) % 3) * half[(axis + 1) % 3];
    const Vector3d v = sign * Vector3d::Unit((axis + 2) % 3) * half[(axis + 2) % 3];
    builder.start_planar(kSides[side], normal, centre);
    builder.quad(centre - u - v, centre + u - v, centre + u + v, centre - u + v);
  }
}

void add(const CylinderShape& cylinder, Builder& builder) {
  const int steps = chord_count(cylinder.radius_m, kSagitta_m);
  const double r = cylinder.radius_m, h = cylinder.length_m / 2.0;
  const auto rim = [&](int step, double z_m) { return on_circle(r, step, steps, z_m); };
  builder.start_curved("side");
  for (int i = 0; i < steps; ++i)
    builder.quad(rim(i, -h), rim(i + 1, -h), rim(i + 1, h), rim(i, h));
  builder.start_planar("+z", Vector3d::UnitZ(), {0, 0, h});
  for (int i = 0; i < steps; ++i) builder.triangle({0, 0, h}, rim(i, h), rim(i + 1, h));
  builder.start_planar("-z", -Vector3d::UnitZ(), {0, 0, -h});
  for (int i = 0; i < steps; ++i) builder.triangle({0, 0, -h}, rim(i + 1, -h), rim(i, -h));
}

void add(const SphereShape& sphere, Builder& builder) {
  const int steps =
      chord_count(sphere.radius_m, kSagitta_m / 2.0);  // sagittas along and across add up
  const int rings = (steps + 1) / 2;
  const auto point = [&](int ring, int step) {
    const double polar_rad = kPi * ring / rings;
    return on_circle(sphere.radius_m * std::sin(polar_rad), step, steps,
                     -sphere.radius_m * std::cos(polar_rad));
  };
  builder.start_curved("surface");
  for (int i = 0; i < steps; ++i) builder.triangle(point(0, 0), point(1, i + 1), point(1, i));
  for (int ring = 1; ring + 1 < rings; ++ring)
    for (int i = 0; i < steps; ++i)
      builder.quad(point(ring, i), point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i));
  for (int i = 0; i < steps; ++i)
    builder.triangle(point(rings, 0), point(rings - 1, i), point(rings - 1, i + 1));
}

void add(const PlaneShape& plane, Builder& builder) {
  const Vector3d normal = plane.normal.normalized();
  const Vector3d u = normal.unitOrthogonal() * kPlaneHalfSide_m;
  const Vector3d v = normal.cross(u);
  builder.start_planar("surface", normal, Vector3d::Zero(), false);
  builder.quad(-u - v, u - v, u + v, -u + v);
}

Vector3d normal_of(const MeshShape& mesh, const std::array<int, 3>& triangle) {
  const Vector3d& a = mesh.vertices_m[triangle[0]];
  return (mesh.vertices_m[triangle[1]] - a).cross(mesh.vertices_m[triangle[2]] - a).normalized();
}

void add(const MeshShape& mesh, Builder& builder) {
  const std::vector<int> patches = coplanar_patches(mesh);
  std::vector<std::size_t> order(patches.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return patches[a] < patches[b]; });
  int started = -1;
  for (const std::size_t i : order) {
    const std::array<int, 3>& t = mesh.triangles[i];
    if (patches[i] != started) {
      started = patches[i];
      builder.start_planar(std::to_string(started), normal_of(mesh, t), mesh.vertices_m[t[0]]);
    }
    builder.triangle(mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]]);
  }
}

}  // namespace

void tessellate(const Shape& shape, Tessellation& tessellation) {
  Builder builder(shape, tessellation);
  std::visit([&](const auto& geometry) { add(geometry, builder); }, shape.geometry);
}

}  // namespace ribbon_mapper::sim
