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

/// A box centred at the origin of the shape's frame.
struct BoxShape {
  Eigen::Vector3d size_m;  ///< edge lengths along x, y and z
};

/// A cylinder along z, centred at the origin of the shape's frame.
struct CylinderShape {
  double radius_m;  ///< of its circle
  double length_m;  ///< along z
};

/// A sphere centred at the origin of the shape's frame.
struct SphereShape {
  double radius_m;  ///< distance of its surface from the centre
};

/// An unbounded plane through the origin of the shape's frame. SDF uses the size of a collision
/// plane for display only.
struct PlaneShape {
  Eigen::Vector3d normal;  ///< need not be of unit length
};

/// A triangle mesh in the shape's frame.
struct MeshShape {
  std::vector<Eigen::Vector3d> vertices_m;    ///< corners, shared by triangles or not
  std::vector<std::array<int, 3>> triangles;  ///< indices into `vertices_m`
};

/// One collision element of the world.
struct Shape {
  std::string name;                     ///< model::link::collision
  Pose T_map_shape = Pose::Identity();  ///< pose of the shape in map
  /// What it looks like in its own frame.
  std::variant<BoxShape, CylinderShape, SphereShape, PlaneShape, MeshShape> geometry;
  std::string label = {};  ///< what it is, as its world says; empty: the world says nothing
};

}  // namespace ribbon_mapper::sim
