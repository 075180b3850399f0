// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How the ranges of a laser become the lines of the three-line buffer (section 4.1 of the paper).
struct ScanConfig {
  /// Standard deviation of a range [m]. UTM-30LX: 0.01 by the repeatability of its datasheet, 0.018
  /// as measured by Pomerleau et al. 2012. The larger one is the safe choice.
  double range_sigma_m = 0.018;

  /// Standard deviation of a beam's direction [deg]: a uniform error over the UTM-30LX's step of a
  /// quarter of a degree.
  double direction_sigma_deg = 0.07;

  /// Smallest range that counts as a return [m], whatever the driver allows.
  double min_range_m = 0.3;
  /// Largest range that counts as a return [m], whatever the driver allows.
  double max_range_m = 30.0;

  /// Half the side of the column about the base frame's origin in which returns are ignored [m],
  /// because they lie on the robot itself. The PR2's footprint is a square of 0.65 m, which
  /// pr2_navigation ignores at any height; 2.5 cm are added for what protrudes. 0: no column.
  double body_half_size_m = 0.35;
  /// Height of that column [m]. The PR2's tilting laser is above it. 0: no column.
  double body_height_m = 1.0;

  /// Largest angle between a beam and the steps to both its neighbours, one nearer and one
  /// further, at which its return counts as a mixed pixel [deg]. Mixed pixels hang in mid-air
  /// between two depths. Surfaces seen at smaller angles are lost, but give no ribbons anyway
  /// (see ribbon.min_grazing_angle_deg). 0: mixed pixels are kept.
  double mixed_pixel_angle_deg = 4.0;

  /// Distance between a line's beams and those of the line before it, in units of range_sigma_m
  /// (median over the beams), from which the line enters the buffer. Closer lines are averaged;
  /// the standard deviation of a mean of n lines is smaller by the square root of n.
  double line_step_sigmas = 1.0;

  /// Smallest distance between a line and the lines before and after it that its normals are
  /// estimated with, in units of range_sigma_m. Below it, a normal across the lines is noise. Use 3
  /// for a laser whose lines lie far closer together than its noise.
  double base_line_sigmas = 1.0;

  /// False: all beams of a line are placed at the pose of its middle, which measures the benefit of
  /// the de-skewing of section 5.1.
  bool deskew = true;
};

}  // namespace ribbon_mapper
