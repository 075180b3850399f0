// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "slam/places/place_search.hpp"

namespace ribbon_mapper::slam {

/// Where a history is torn: lines before it fit where they are, lines behind it fit if moved.
struct Seam {
  std::uint32_t first = 1;  ///< the first line that does not fit where it is
  std::uint32_t end = 1;    ///< the first line that fits if moved; at least `first`
  /// The line that parts best what fits where it is from what fits if moved, whatever else is seen.
  /// Nothing if it is one of these two.
  std::optional<std::uint32_t> split = std::nullopt;
};

/// Returns the seam of lines that fit known walls first where they are, then if moved by
/// `T_start_start`.
Seam seam_of(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
             const KnownScene& scene, const AssociationGates& gates);

/// Returns the same by the lines that fit only one way: it holds those in between that fit both
/// ways or none.
Seam parting_of(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                const KnownScene& scene, const AssociationGates& gates);

/// Returns one behind the last line of a range that fits known walls where it is, if all before it
/// are to fit as well.
std::uint32_t end_of_fitting(const PosedLines& lines, const LineRange& range,
                             const KnownScene& scene, const AssociationGates& gates);

/// Returns the line at which the known walls that moved lines see were in sight for the last time:
/// a quarter of them, by length, until then or later.
std::uint32_t last_seen(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                        const KnownScene& scene, const AssociationGates& gates);

/// Moves the lines behind a seam, and those in it by a part that grows from line to line.
void move_behind(const Seam& seam, const Pose& T_start_start, PosedLines& lines);

/// Returns the scale of the odometry's noise that would explain a move, see
/// OdometryNoise::planar_scale.
double scale_of(const Seam& seam, const Pose& T_start_start, const PosedLines& lines);

/// Returns the first line of the second of a range that contradicts its odometry most: the lines
/// behind it may have been put on wrong walls. Nothing if no second needs a scale beyond
/// `max_scale`, see scale_of(). Steps that were declared wrong are left out.
std::optional<std::uint32_t> most_strained(const PosedLines& lines, const LineRange& range,
                                           double max_scale);

}  // namespace ribbon_mapper::slam
