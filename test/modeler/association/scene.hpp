// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "modeler/association/plane_map.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/plane.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper::mini_world {

/// The ribbon of these points in their order, a centimetre apart, seen by three lines 2 cm apart.
Ribbon ribbon_of(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal);

/// A ribbon as if points had been seen every centimetre from `from` to `to` on a face with this
/// normal, by three lines 2 cm apart.
Ribbon ribbon_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      const Eigen::Vector3d& normal);

/// Ribbons side by side, every 4 cm: from `corner` along `u`, stepping along `v` (orthogonal);
/// the normal is that of u x v.
std::vector<Ribbon> patch(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                          const Eigen::Vector3d& v);

/// Ribbons, all acquired from the map's origin.
struct Scene {
  std::vector<Ribbon> ribbons;
  std::vector<UnassignedPoints> unassigned;
  std::vector<StampedPose> poses{StampedPose{}};

  void add(const std::vector<Ribbon>& more) {
    ribbons.insert(ribbons.end(), more.begin(), more.end());
  }
  PosedObservations observations() const { return {ribbons, unassigned, poses}; }
  PlaneMap map(const AssociationGates& gates = AssociationConfig{}.corrected,
               std::int64_t first_id = 0) const;
  /// All ribbons in one hypothesis, whether they fit or not.
  Hypothesis whole() const;
};

/// A plane z = `z_m` with these cells of 5 cm, seen from above.
Plane level_plane(double z_m, const std::vector<PlaneCell>& cells);
/// Cells [0, columns) x [0, rows), a point in each.
std::vector<PlaneCell> rectangle(int columns, int rows, int u0 = 0, int v0 = 0);

}  // namespace ribbon_mapper::mini_world
