// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns a level plane of 10 cm x 5 cm at z = 0.5 m with the cells (0, 0) and (1, 0).
inline Plane small_plane() {
  Plane plane;
  plane.id = 7;
  plane.d_m = -0.5;
  plane.area_m2 = 0.005;
  plane.centroid = {0.05, 0.025, 0.5};
  plane.origin = {0.0, 0.0, 0.5};
  plane.cells = {{0, 0, 3, 0.0F, 0.0F}, {1, 0, 2, 0.0F, 0.0F}};
  plane.outlines = {
      {{{0.0, 0.0, 0.5}, {0.125, 0.0, 0.5}, {0.125, 0.0625, 0.5}, {0.0, 0.0625, 0.5}}, {}}};
  return plane;
}

}  // namespace ribbon_mapper
