// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/modeler.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper {

/// Returns a model of half a room, seen by a laser of few beams, with a correction and lines after
/// it. The file of it is small. Models of other seeds have other ranges.
inline Modeler small_model(unsigned seed = 1) {
  using namespace mini_world;
  const Motion motion{around_the_middle, to_and_fro, wandering_drift};
  const Lines lines = drive(room(), motion, 0.0, 1.5, Laser{61, 0.005, seed});
  ModelerConfig config;
  config.ribbon.min_length_m = 0.4;
  const Lines first(lines.begin(), lines.begin() + 40);
  Modeler modeler = model_of(first, config);
  modeler.correct(true_trajectory(Lines(lines.begin(), lines.begin() + 30), 5));
  for (std::size_t i = first.size(); i < lines.size(); ++i) {
    modeler.add_scan_line(lines[i].beams, lines[i].poses);
  }
  return modeler;
}

}  // namespace ribbon_mapper
