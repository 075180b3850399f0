// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "slam/lines/context.hpp"
#include "slam/places/seam.hpp"

namespace ribbon_mapper::slam {

/// What the lines around a place say of a slip there: whether those just behind it fit what was
/// seen just before it where they are, or moved.
struct SlipEvidence {
  /// How many more ribbons lie on walls if moved, negative if fewer. Zero if it takes more to
  /// believe in a plane: they may be chance.
  double ribbons = 0.0;
  bool is_explained = false;     ///< most of what does not fit where it is fits if moved
  bool is_contradicted = false;  ///< most of what fits where it is does not fit if moved
};

/// Returns what the lines around a line say of a slip there that has made the move `T_start_start`
/// of all later ones. Nothing speaks for it or against it if there are none yet.
SlipEvidence slip_evidence(const PosedLines& lines, std::uint32_t line, const Pose& T_start_start,
                           const EstimateSettings& settings);

/// A slip that fits what is seen around it.
struct FittingSlip {
  Seam seam;              ///< where the wheels have slipped
  SlipEvidence evidence;  ///< what the lines around it say
};

/// Returns the slips in a range of lines that fit best if a move, `T_start_start`, is right: the
/// best first, two at most. All put as many more ribbons on walls as it takes to believe in a
/// plane.
std::vector<FittingSlip> fitting_slips(const PosedLines& lines, const LineRange& range,
                                       const Pose& T_start_start, const EstimateSettings& settings);

}  // namespace ribbon_mapper::slam
