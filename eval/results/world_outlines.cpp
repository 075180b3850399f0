// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/world_outlines.hpp"

#include "eval/results/chains.hpp"

namespace ribbon_mapper::eval {

std::vector<std::vector<Eigen::Vector2d>> world_outlines(const sim::World& world) {
  constexpr double kTolerance_m = 0.005;  // less than a line's width in the figure
  std::vector<Segment> segments;
  for (const double z_m : {0.4, 0.73, 1.5}) {
    for (const Segment& segment : world.outlines_at(z_m)) segments.push_back(segment);
  }
  return chains_of(segments, kTolerance_m);  // merges what is equal at several heights
}

}  // namespace ribbon_mapper::eval
