// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::mini_world {

/// Returns every field of every plane, so that bitwise equal planes give equal strings.
std::string bytes_of(const std::vector<Plane>& planes);

/// Expects the same planes in the same order.
///
/// Ids and numbers of ribbons must be equal; normals, offsets, grids and covariances may differ by
/// `tolerance` (m, or the length of the difference of unit vectors), areas by border cells.
void expect_same(const std::vector<Plane>& expected, const std::vector<Plane>& actual,
                 double tolerance);

/// Returns the planes with all ids set to 0, in an order that does not depend on ids.
std::vector<Plane> anonymous(std::vector<Plane> planes);

/// Returns the plane after a rigid motion.
Plane moved(Plane plane, const Pose& T);

/// Expects exactly one plane for each face, and no other. Its normal may differ by `angle_deg`, and
/// its centroid may lie up to `distance_m` off the face.
void expect_one_for_each(const World& world, const std::vector<Plane>& planes, double angle_deg,
                         double distance_m);

}  // namespace ribbon_mapper::mini_world
