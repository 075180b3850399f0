// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How beams become the lines of the three-line buffer.
struct ScanConfig {
  /// Standard deviation of one range [m]. UTM-30LX: 0.01 by its datasheet's repeatability, 0.018
  /// measured by Pomerleau et al. 2012; the larger one is the safe choice.
  double range_sigma_m = 0.018;

  /// Standard deviation of a beam's direction [deg]: the UTM-30LX's steps of a quarter of a degree,
  /// evenly distributed.
  double direction_sigma_deg = 0.07;

  /// Ranges outside of [least, most] are no returns, whatever the driver allows [m].
  double min_range_m = 0.3;
  double max_range_m = 30.0;

  /// Returns on the robot itself are none: a column about the base frame's origin, so far to each
  /// side [m] and up to this height [m]; 0: no column. PR2: its footprint is a square of 0.65 m,
  /// which pr2_navigation leaves out at any height, plus 2.5 cm for what sticks out; up to the
  /// tilting laser.
  double body_half_size_m = 0.35;
  double body_height_m = 1.0;

  /// Returns in mid-air between two depths are none: those from whose neighbours, one nearer and
  /// one further, both steps lie within this angle of the beam [deg]; 0: all are kept. What is lost
  /// are surfaces seen under a smaller angle, which give no ribbons anyway
  /// (ribbon.min_grazing_angle_deg).
  double mixed_pixel_angle_deg = 4.0;

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
