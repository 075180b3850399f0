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

/// Returns the ribbon of these points, which follow each other a centimetre apart, as seen by three
/// scan lines 2 cm apart.
Ribbon ribbon_of(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal);

/// Returns the ribbon from `from` to `to` on a face with this normal, with a point every
/// centimetre, as seen by three scan lines 2 cm apart.
Ribbon ribbon_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      const Eigen::Vector3d& normal);

/// Returns parallel ribbons 4 cm apart on a rectangle: along `u` from `corner`, one after the other
/// along the orthogonal `v`. Their normal is that of u x v.
std::vector<Ribbon> patch(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                          const Eigen::Vector3d& v);

/// Ribbons and unassigned points that were all acquired at one pose.
struct Scene {
  std::vector<Ribbon> ribbons;                                   ///< in the frame of the pose
  std::vector<UnassignedPoints> unassigned{UnassignedPoints{}};  ///< one element, of the pose
  std::vector<StampedPose> poses{StampedPose{}};                 ///< at first the origin of map

  /// Appends ribbons.
  void add(const std::vector<Ribbon>& more) {
    ribbons.insert(ribbons.end(), more.begin(), more.end());
  }
  /// Returns the ribbons and points at the pose. Valid until they change.
  PosedObservations observations() const { return {ribbons, unassigned, poses}; }
  /// Returns a map of all ribbons.
  PlaneMap map(const AssociationGates& gates = AssociationConfig{}.corrected,
               std::int64_t first_id = 0) const;
  /// Returns one hypothesis of all ribbons, whether they fit or not.
  Hypothesis whole() const;
};

/// Returns a plane z = `z_m` with these cells of 5 cm, seen from above.
Plane level_plane(double z_m, const std::vector<PlaneCell>& cells);
/// Returns the cells of a rectangle with its lower left cell at (u0, v0), with one point each.
std::vector<PlaneCell> rectangle(int columns, int rows, int u0 = 0, int v0 = 0);

}  // namespace ribbon_mapper::mini_world
