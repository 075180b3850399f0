// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/modeler_config.hpp"
#include "modeler/ros/bag_check/bag_report.hpp"

namespace ribbon_mapper {

/// How densely a recording covers surfaces, as measured.
struct LineSpacing {
  double line_step_rad = 0.0;   ///< median angle between successive lines
  double beam_step_rad = 0.0;   ///< angle between neighbouring beams
  double sweeps = 1.0;          ///< number of times that the laser passed over a surface
  double noise_m = 0.0;         ///< standard deviation of a range
  double median_range_m = 0.0;  ///< of the usable ranges
  double far_range_m = 0.0;     ///< 90 % of the usable ranges are below it
  bool base_stands = false;     ///< the robot does not move

  /// Returns the mean distance between lines at the far range [m]. Several sweeps fill the gaps.
  double line_gap_m() const { return line_step_rad * far_range_m / sweeps; }
  /// Returns the distance between beams at the far range [m].
  double beam_gap_m() const { return beam_step_rad * far_range_m; }
};

/// Returns the preset with the keys changed that the spacing of lines and beams and the noise ask
/// for. docs/how_to/make_a_preset_for_another_laser.md has the rules.
ModelerConfig adapted(ModelerConfig preset, const LineSpacing& spacing);

/// Adds a warning with the measured values and the keys for everything that the preset does not
/// allow: lines or beams further apart, or nearer, or more noise.
void report_spacing(const LineSpacing& spacing, const ModelerConfig& preset, BagReport& report);

}  // namespace ribbon_mapper
