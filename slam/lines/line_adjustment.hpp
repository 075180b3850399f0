// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "slam/lines/known_planes.hpp"

namespace ribbon_mapper::slam {

/// Lines [first, end) whose poses are adjusted, and lines before them whose poses are known.
struct AdjustedLines {
  std::uint32_t first = 1;             ///< at least 1: the pose of the line before it is known
  std::uint32_t end = 1;               ///< one behind the last line
  std::vector<std::uint32_t> context;  ///< lines with known poses, ascending, all before `first`
  /// Covariances with which the last of the lines were tracked (see PoseBelief), of as many as are
  /// known. They narrow the gates within which these lines match known planes.
  std::vector<Matrix6> tracked;
};

/// Adjusts the poses of lines together with the planes that they see.
///
/// There is a round for each of EstimateConfig::gates. It matches ribbons with the planes of the
/// context, gathers those that lie at none of them to new planes, and takes Gauss-Newton steps on
/// all poses and planes.
void adjust_lines(PosedLines& lines, const AdjustedLines& which, const OdometryNoise& noise,
                  const EstimateSettings& settings);

/// Returns the covariances of the lines' poses where they are, in their order, given the poses of
/// the context and of the line before: those of the last round of adjust_lines(). No step is taken.
/// Errors are those of PoseBelief, along the axes of `start`.
std::vector<Matrix6> line_covariances(const PosedLines& lines, const AdjustedLines& which,
                                      const OdometryNoise& noise, const EstimateSettings& settings);

}  // namespace ribbon_mapper::slam
