// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// Which part of a mesh file is meant, and how it is placed (SDF: <mesh>).
struct MeshSelection {
  std::string submesh;  ///< name of a mesh or node of the file; empty: the whole file
  bool center_submesh = false;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

/// Reads a mesh in any format of assimp, node transforms applied, in the file's own axes.
/// Throws std::runtime_error if the file cannot be read, or has no such part, or no triangles.
MeshShape load_mesh(const std::string& path, const MeshSelection& selection);

}  // namespace ribbon_mapper::sim
