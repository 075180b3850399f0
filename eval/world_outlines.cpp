// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/world_outlines.hpp"

namespace ribbon_mapper::eval {

std::vector<std::vector<Eigen::Vector2d>> world_outlines(const sim::World& world) {
  std::vector<std::vector<Eigen::Vector2d>> outlines;
  for (const double z_m : {0.4, 0.73, 1.5}) {
    for (const auto& segment : world.outlines_at(z_m)) outlines.push_back({segment[0], segment[1]});
  }
  return outlines;
}

}  // namespace ribbon_mapper::eval
