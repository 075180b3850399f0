// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// One side of a shape, one coplanar patch of a mesh, or the curved surface of a round shape.
struct Face {
  std::string name;                                   ///< model::link::collision/side
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outwards, in map; arbitrary when curved
  double d_m = 0.0;                                   ///< n.p + d = 0 in map
  bool planar = true;                                 ///< false for a curved surface
  bool bounded = true;                                ///< false for the side of a plane shape
  std::string label = {};                             ///< Shape::label
};

/// A triangle of the world's surface.
struct Triangle {
  std::array<Eigen::Vector3d, 3> corners_m;  ///< in map, counter-clockwise seen from outside
  int face = 0;                              ///< index into Tessellation::faces
};

/// The surface of a world as triangles.
struct Tessellation {
  std::vector<Face> faces;          ///< what the triangles belong to
  std::vector<Triangle> triangles;  ///< in the order of their faces
};

/// Adds the surface of `shape` to `tessellation`. Flat sides are exact, and a curved side lies at
/// most 0.19 mm below its true surface, up to radii of 40 m. A plane becomes a square of 200 m
/// about its own origin.
void tessellate(const Shape& shape, Tessellation& tessellation);

/// Returns, for each triangle, the index of its coplanar patch, counted from 0. Triangles of a
/// patch are connected by edges and lie within 0.05 degrees and 0.1 mm of one plane.
std::vector<int> coplanar_patches(const MeshShape& mesh);

}  // namespace ribbon_mapper::sim
