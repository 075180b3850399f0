// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::sim {

struct BoxShape {
  Eigen::Vector3d size_m;
};
struct CylinderShape {  ///< along z, centred
  double radius_m;
  double length_m;
};
struct SphereShape {
  double radius_m;
};
/// Without bounds: SDF gives a collision plane's size a meaning for the picture only.
struct PlaneShape {
  Eigen::Vector3d normal;
};
struct MeshShape {
  std::vector<Eigen::Vector3d> vertices_m;
  std::vector<std::array<int, 3>> triangles;  ///< indices into `vertices_m`
};

/// One collision element of the world.
struct Shape {
  std::string name;  ///< model::link::collision
  Pose T_map_shape = Pose::Identity();
  std::variant<BoxShape, CylinderShape, SphereShape, PlaneShape, MeshShape> geometry;
};

}  // namespace ribbon_mapper::sim
