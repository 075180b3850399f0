// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/results/results.hpp"

namespace ribbon_mapper::eval {

/// Returns a wall at x = `x_m` of 40 x 40 cells, observed from smaller x; y begins at `y_begin_m`.
inline Plane sample_wall(std::int64_t id, double x_m, double y_begin_m) {
  Plane plane;
  plane.id = id;
  plane.normal = {-1.0, 0.0, 0.0};
  plane.d_m = x_m;
  plane.area_m2 = 4.0;
  plane.origin = {x_m, y_begin_m, 0.0};
  plane.axis_u = {0.0, 0.0, 1.0};
  plane.axis_v = {0.0, 1.0, 0.0};
  plane.centroid = {x_m, y_begin_m + 1.0, 1.0};
  for (int v = 0; v < 40; ++v) {
    for (int u = 0; u < 40; ++u) plane.cells.push_back({u, v, 1, 0.0F, 0.0F});
  }
  plane.outlines = {{{grid_corner(plane, 0, 0), grid_corner(plane, 40, 0),
                      grid_corner(plane, 40, 40), grid_corner(plane, 0, 40)},
                     {}}};
  return plane;
}

/// Returns results with one true wall, its copy due to drift, and a far extra plane. The robot
/// drove 4 m ahead; its end drift is half a metre and ten degrees.
inline Results sample_results() {
  Results results;
  const Plane wall = sample_wall(1, 5.0, 0.0);
  const Plane doubled = sample_wall(2, 5.05, 0.0), extra = sample_wall(3, -5.0, 0.0);
  results.models = {{wall, doubled, extra}, {wall, extra}, {wall}, {wall}};
  results.truth = {patch_of(wall)};
  results.trajectory_truth = {{Time(0), planar_pose(0.0, 0.0, 0.0)},
                              {Time(1'000'000'000), planar_pose(4.0, 0.0, 0.0)}};
  results.trajectory_after = results.trajectory_before = results.trajectory_truth;
  results.trajectory_before.back().T_map_base = planar_pose(4.3, 0.4, 10.0 * M_PI / 180.0);
  results.world_outlines = {{{5.0, 0.0}, {5.0, 2.0}, {5.1, 2.0}, {5.1, 0.0}}};
  return results;
}

}  // namespace ribbon_mapper::eval
