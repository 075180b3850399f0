// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
/// Models a room of six planes from the lines of a tilting laser on a robot that turns on the spot.
#include <cstdio>

#include "examples/room_scanner.hpp"
#include "modeler/modeler.hpp"

using namespace ribbon_mapper;

int main() {
  const auto T_map_base = [](double time_s) { return planar_pose(0.0, 0.0, 0.5 * time_s); };

  Modeler modeler(ModelerConfig{});
  for (int line = 0; line < 600; ++line) {
    const LaserBeams beams = room_scanner::beams_of_line(line, T_map_base);
    const LinePoses poses = room_scanner::poses_of_line(line, T_map_base);
    modeler.add_scan_line(beams, poses);
  }

  const std::vector<Plane> planes = modeler.planes();
  for (const Plane& plane : planes) {
    std::printf("plane %lld: normal (%5.2f, %5.2f, %5.2f), d %5.2f m, area %5.2f m2\n",
                static_cast<long long>(plane.id), plane.normal.x(), plane.normal.y(),
                plane.normal.z(), plane.d_m, plane.area_m2);
  }
  return planes.size() == 6 ? 0 : 1;
}
