// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::mini_world {

/// Every field of every plane, bit by bit.
std::string bytes_of(const std::vector<Plane>& planes);

/// Expects the same planes in the same order: ids, ribbons, and normals, offsets, areas, grids,
/// covariances to `tolerance` (m, m2, or length of the difference of unit vectors).
void expect_same(const std::vector<Plane>& expected, const std::vector<Plane>& actual,
                 double tolerance);

/// Without ids, and in an order that does not depend on them.
std::vector<Plane> anonymous(std::vector<Plane> planes);

/// The plane moved rigidly.
Plane moved(Plane plane, const Pose& T);

/// Expects one plane for each face, within these of its normal and, at the plane's centroid, of its
/// place; and no other.
void expect_one_for_each(const World& world, const std::vector<Plane>& planes, double angle_deg,
                         double distance_m);

}  // namespace ribbon_mapper::mini_world
