// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/scan/line_buffer.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::mini_world {

/// A robot that stands at the origin (or somewhere else) while its laser tilts at a constant speed.
inline Motion tilting(double tilt_speed_rad_s, double tilt_rad = 0.0,
                      const Pose& T_map_base = Pose::Identity()) {
  return {[=](double) { return T_map_base; },
          [=](double time_s) { return tilt_rad + tilt_speed_rad_s * time_s; }, no_drift};
}

/// A full buffer of three lines whose middle one begins at `middle_s`.
inline LineBuffer three_lines(const World& world, const Motion& motion, double middle_s = 0.0,
                              const Laser& laser = {}, const ScanConfig& config = {}) {
  LineBuffer buffer(0.0);
  for (const Line& line : drive(world, motion, middle_s - 0.025, middle_s + 0.026, laser)) {
    place_beams(line.beams, line.poses, config, buffer.incoming());
    buffer.push();
  }
  buffer.advance();
  return buffer;
}

}  // namespace ribbon_mapper::mini_world
