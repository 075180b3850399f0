// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "slam/lines/context.hpp"
#include "slam/places/seam.hpp"

namespace ribbon_mapper::slam {

/// A slip that the lines around it show by themselves: those behind it fit what was seen just
/// before it if they are moved.
struct EvidentSlip {
  Seam seam;       ///< where the wheels have slipped
  double ribbons;  ///< how many more ribbons behind it lie on walls seen just before it, if moved
  bool is_explained;  ///< most of what did not fit there fits if moved
};

/// Returns the slip in a range of lines that is most evident if a move, `T_start_start`, is right.
/// Nothing if no slip puts as many ribbons on walls as it takes to believe in a plane.
std::optional<EvidentSlip> evident_slip(const PosedLines& lines, const LineRange& range,
                                        const Pose& T_start_start,
                                        const EstimateSettings& settings);

}  // namespace ribbon_mapper::slam
