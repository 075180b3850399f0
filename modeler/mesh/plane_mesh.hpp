// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// The outlines of a plane as triangles.
struct PlaneMesh {
  std::string name;                                   ///< "plane", its id, and its label if known
  std::int64_t plane_id = 0;                          ///< id of the plane
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the observed side
  std::vector<Eigen::Vector3d> vertices;              ///< in map [m]
  /// Indices into `vertices`, counter-clockwise about the normal.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Returns the outlines of a plane as triangles, by the tessellator of GLU. Doors and windows stay
/// open, and the area is that of the outlines.
PlaneMesh mesh_of(const Plane& plane);

/// Returns a mesh for each plane. `labels` are those of the planes, in their order, or none.
std::vector<PlaneMesh> meshes_of(const std::vector<Plane>& planes,
                                 const std::vector<std::string>& labels = {});

}  // namespace ribbon_mapper
