// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/world.hpp"

#include <utility>

#include "sim/sdf/sdf_reader.hpp"
#include "sim/world/contact_checker.hpp"
#include "sim/world/world_content.hpp"

namespace ribbon_mapper::sim {
namespace {

Tessellation tessellated(const std::vector<Shape>& shapes) {
  Tessellation tessellation;
  for (const Shape& shape : shapes) tessellate(shape, tessellation);
  return tessellation;
}

/// Returns the two points where the triangle's edges cross the height `z_m`, or none.
std::vector<Eigen::Vector2d> section(const Triangle& triangle, double z_m) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = triangle.corners_m[i];
    const Eigen::Vector3d& b = triangle.corners_m[(i + 1) % 3];
    if ((a.z() < z_m) == (b.z() < z_m)) continue;
    points.emplace_back((a + (b - a) * (z_m - a.z()) / (b.z() - a.z())).head<2>());
  }
  return points;
}

}  // namespace

struct World::State {
  State(const std::string& path, const SdfShapes& sdf, RayCasterKind caster)
      : tessellation(tessellated(sdf.shapes)),
        extent(plausible_extent(path, tessellation)),
        content("world " + path + ": " + content_text(sdf, extent)),
        warnings(warning_texts(sdf.notes, extent)),
        rays(make_ray_caster(caster, tessellation.triangles)),
        contacts(sdf.shapes) {}

  Tessellation tessellation;
  Eigen::AlignedBox3d extent;
  std::string content;
  std::vector<std::string> warnings;
  std::unique_ptr<const RayCaster> rays;
  ContactChecker contacts;
};

World World::load(const std::string& path, const std::vector<std::string>& model_paths,
                  RayCasterKind caster, bool visuals) {
  return World(std::make_unique<State>(path, read_sdf(path, model_paths, visuals), caster));
}

World::World(std::unique_ptr<State> state) : state_(std::move(state)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

std::optional<Hit> World::cast(const Eigen::Vector3d& origin_map,
                               const Eigen::Vector3d& direction_map, double max_range_m) const {
  return state_->rays->cast({origin_map, direction_map}, max_range_m);
}

const std::vector<Face>& World::faces() const { return state_->tessellation.faces; }

const std::vector<Triangle>& World::triangles() const { return state_->tessellation.triangles; }

const Eigen::AlignedBox3d& World::extent_m() const { return state_->extent; }

const std::string& World::content() const { return state_->content; }

const std::vector<std::string>& World::warnings() const { return state_->warnings; }

std::optional<std::string> World::contact(const Pose& T_map_box,
                                          const Eigen::Vector3d& size_m) const {
  return state_->contacts.contact(T_map_box, size_m);
}

std::vector<std::array<Eigen::Vector2d, 2>> World::outlines_at(double z_m) const {
  std::vector<std::array<Eigen::Vector2d, 2>> segments;
  for (const Triangle& triangle : triangles()) {
    const std::vector<Eigen::Vector2d> points = section(triangle, z_m);
    if (points.size() == 2) segments.push_back({points[0], points[1]});
  }
  return segments;
}

}  // namespace ribbon_mapper::sim
