// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How beams become the lines of the three-line buffer.
struct ScanConfig {
  /// Standard deviation of one range [m]. UTM-30LX: 0.01 by its datasheet's repeatability, 0.018
  /// measured by Pomerleau et al. 2012; the larger one is the safe choice.
  double range_sigma_m = 0.018;

  /// Ranges outside of [least, most] are no returns, whatever the driver allows [m].
  double least_range_m = 0.3;
  double most_range_m = 30.0;

  /// A line enters the buffer when its beams lie this many range_sigma_m from those of the line
  /// before it (median over the beams). Lines closer than that are pooled: the mean of n of them
  /// has a sigma smaller by the root of n.
  double line_step_sigmas = 1.0;

  /// The lines before and after a line that its normals are taken with lie at least this many
  /// range_sigma_m away: below, a normal across the lines is noise. For a laser whose lines lie far
  /// closer together than its noise: 3, with steps of 1.
  double base_line_sigmas = 1.0;

  /// False: all beams of a line are placed at the pose of its middle (to measure what
  /// the de-skewing of section 5.1 is worth).
  bool deskew = true;
};

}  // namespace ribbon_mapper
