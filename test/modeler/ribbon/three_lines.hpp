// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/scan/three_lines.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::mini_world {

/// Returns the motion of a robot that stands while its laser tilts at a constant speed.
inline Motion tilting(double tilt_speed_rad_s, double tilt_rad = 0.0,
                      const Pose& T_map_base = Pose::Identity()) {
  return {[=](double) { return T_map_base; },
          [=](double time_s) { return tilt_rad + tilt_speed_rad_s * time_s; }, no_drift};
}

/// Three scan lines, which ThreeLines refers to.
struct LineTriple {
  ScanLine previous;  ///< line before the middle one
  ScanLine middle;    ///< line whose ribbons are extracted
  ScanLine next;      ///< line after the middle one

  /// Refers to the lines.
  operator ThreeLines() const { return {previous, middle, next}; }
};

/// Places the beams of three lines.
inline LineTriple placed(const std::vector<Line>& lines, const ScanConfig& config = {}) {
  LineTriple triple;
  place_beams(lines.at(0).beams, lines.at(0).poses, config, triple.previous);
  place_beams(lines.at(1).beams, lines.at(1).poses, config, triple.middle);
  place_beams(lines.at(2).beams, lines.at(2).poses, config, triple.next);
  return triple;
}

/// Returns three successive lines, of which the middle one begins at `middle_s`.
inline LineTriple three_lines(const World& world, const Motion& motion, double middle_s = 0.0,
                              const Laser& laser = {}, const ScanConfig& config = {}) {
  return placed(drive(world, motion, middle_s - 0.025, middle_s + 0.026, laser), config);
}

}  // namespace ribbon_mapper::mini_world
