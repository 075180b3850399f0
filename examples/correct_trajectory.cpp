// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
/// Models a room with poses that drift, then corrects the trajectory as a loop closure would.
#include <cmath>
#include <cstdio>

#include "examples/room_scanner.hpp"
#include "modeler/modeler.hpp"

using namespace ribbon_mapper;

namespace {

/// Returns the robot's true pose: it drives in a circle, once in 15 s.
Pose T_map_base_true(double time_s) {
  const double angle_rad = 2.0 * M_PI * time_s / 15.0;
  return planar_pose(0.6 * std::cos(angle_rad), 0.6 * std::sin(angle_rad), angle_rad);
}

/// Returns the pose that a drifting localisation reports, 0.6 m and 11 degrees off after 15 s.
Pose T_map_base_drifting(double time_s) {
  const double share = time_s / 15.0;
  return planar_pose(0.6 * share, -0.2 * share, 0.2 * share) * T_map_base_true(time_s);
}

}  // namespace

int main() {
  Modeler modeler(ModelerConfig{});
  std::vector<StampedPose> corrected_trajectory;
  for (int line = 0; line < 600; ++line) {
    const LaserBeams beams = room_scanner::beams_of_line(line, T_map_base_true);
    modeler.add_scan_line(beams, room_scanner::poses_of_line(line, T_map_base_drifting));
    const Time middle = middle_of(beams);
    corrected_trajectory.push_back({middle, T_map_base_true(to_seconds(middle))});
  }
  const std::size_t before = modeler.planes().size();

  modeler.correct(corrected_trajectory);
  const std::size_t after = modeler.planes().size();

  std::printf("planes with drifting poses: %zu, corrected: %zu\n", before, after);
  return before > 6 && after == 6 ? 0 : 1;
}
