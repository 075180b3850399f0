// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// The part of a mesh file to load and its scale (SDF: <mesh>).
struct MeshSelection {
  std::string submesh;          ///< name of a mesh or node of the file; empty: the whole file
  bool center_submesh = false;  ///< moves the centre of its bounding box to the origin
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  ///< factors along the axes of the file
};

/// Reads a mesh in any format that assimp reads. Applies the transforms of its nodes and keeps the
/// file's own axes. Throws std::runtime_error that names the file if it cannot be read, lacks the
/// part, or has no triangles, also where assimp itself crashes or hangs on it.
MeshShape load_mesh(const std::string& path, const MeshSelection& selection);

}  // namespace ribbon_mapper::sim
