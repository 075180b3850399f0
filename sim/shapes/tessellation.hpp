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
  bool planar = true;
};

struct Triangle {
  std::array<Eigen::Vector3d, 3> corners_m;  ///< in map, counter-clockwise seen from outside
  int face = 0;                              ///< index into Tessellation::faces
};

struct Tessellation {
  std::vector<Face> faces;
  std::vector<Triangle> triangles;
};

/// Adds the surface of `shape`. Flat sides are exact; a curved side lies at most 0.19 mm below its
/// true surface; a plane becomes a square of 200 m side about its own origin.
void tessellate(const Shape& shape, Tessellation& tessellation);

/// Index of the coplanar patch of each triangle, counted from 0: triangles that share an edge and
/// lie within 0.05 degrees and 0.1 mm of one plane.
std::vector<int> coplanar_patches(const MeshShape& mesh);

}  // namespace ribbon_mapper::sim
