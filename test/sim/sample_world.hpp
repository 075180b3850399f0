// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "sim/world/world.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper::sim {

/// Writes a file and makes its folders.
inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// Returns the SDF of a world that contains `content`.
inline std::string sdf_world(const std::string& content) {
  return "<?xml version='1.0'?><sdf version='1.6'><world name='test'>" + content + "</world></sdf>";
}

/// Returns the SDF of a model with one collision; `pose` is "x y z roll pitch yaw".
inline std::string sdf_model(const std::string& name, const std::string& pose,
                             const std::string& geometry) {
  return "<model name='" + name + "'><static>true</static><pose>" + pose +
         "</pose><link name='link'><collision name='collision'><geometry>" + geometry +
         "</geometry></collision></link></model>";
}

/// Returns the SDF of a box; `size` is "x y z".
inline std::string sdf_box(const std::string& size) {
  return "<box><size>" + size + "</size></box>";
}

/// Returns the SDF of a mesh file.
inline std::string sdf_mesh(const std::string& uri) {
  return "<mesh><uri>" + uri + "</uri></mesh>";
}

/// Returns the SDF of a box between two opposite corners [m].
inline std::string sdf_block(const std::string& name, const Eigen::Vector3d& low,
                             const Eigen::Vector3d& high) {
  std::ostringstream pose, size;
  pose.precision(12);
  size.precision(12);
  pose << (low + high).transpose() / 2.0 << " 0 0 0";
  size << (high - low).transpose();
  return sdf_model(name, pose.str(), sdf_box(size.str()));
}

/// Returns the world that contains `content`.
inline World world_of(const std::string& content, RayCasterKind caster = RayCasterKind::bullet) {
  const TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "test.sdf";
  write_file(path, sdf_world(content));
  return World::load(path.string(), {}, caster);
}

/// Returns an empty room around the origin whose inner sides lie at +-half_m.
inline World hollow_room(const Eigen::Vector3d& half_m,
                         RayCasterKind caster = RayCasterKind::bullet) {
  std::string content;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      Eigen::Vector3d low = -half_m.array() - 0.2, high = half_m.array() + 0.2;
      (side < 0 ? high : low)[axis] = side * half_m[axis];
      content +=
          sdf_block("side_" + std::to_string(axis) + (side < 0 ? "_low" : "_high"), low, high);
    }
  return world_of(content, caster);
}

/// Returns the range [m] from `origin` within a hollow room to its sides, by the slab rule.
inline double range_in_room(const Eigen::Vector3d& half_m, const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& direction) {
  double range_m = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;
    const double side_m = direction[axis] > 0.0 ? half_m[axis] : -half_m[axis];
    range_m = std::min(range_m, (side_m - origin[axis]) / direction[axis]);
  }
  return range_m;
}

}  // namespace ribbon_mapper::sim
