// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "slam/tilting/known_planes.hpp"

namespace ribbon_mapper::slam {

/// Lines whose poses are adjusted, [first, end), and the lines around them whose poses are known.
struct AdjustedLines {
  std::uint32_t first = 1;             ///< the line before it must exist; its pose is known
  std::uint32_t end = 1;               ///< one behind the last line
  std::vector<std::uint32_t> context;  ///< lines with known poses, ascending
};

/// Adjusts the poses of lines together with the planes that they see, by one round for each of
/// `gates`. A round matches ribbons with the context's planes, gathers the others to new planes,
/// and takes Gauss-Newton steps on all poses and planes.
void adjust_lines(PosedLines& lines, const AdjustedLines& which,
                  const std::vector<AssociationGates>& gates, const OdometryNoise& noise,
                  const EstimateSettings& settings);

}  // namespace ribbon_mapper::slam
