// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "modeler/geometry/compact_moments.hpp"
#include "modeler/ribbon/ribbon_samples.hpp"

namespace ribbon_mapper {

/// A maximal run of successive points of one scan line that lie on one plane, estimated with the
/// line before and the line after (eq. 1 of the paper).
///
/// All geometry is in the frame of the acquisition pose and is never edited. Single precision is a
/// hundred thousand times finer than the sensor.
struct Ribbon {
  std::uint32_t pose = 0;        ///< acquisition pose: index into the trajectory
  std::uint32_t first_beam = 0;  ///< index of the first beam on the line
  std::uint32_t last_beam = 0;   ///< index of the last beam on the line
  /// Moments of the points on the middle line, each doubled to both sides across the line by the
  /// base line of the three lines. The plane of these moments is the ribbon's plane.
  CompactMoments moments;
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit normal, towards the sensor
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();   ///< unit direction of the run, in the plane
  float sigma_across_rad = 0.0F;  ///< standard error of the normal about `along`
  float area_m2 = 0.0F;           ///< sum of the surfel areas (eq. 2), each capped
  float length_m = 0.0F;          ///< from the first sample to the last
  RibbonSamples samples;          ///< the points of the middle line; owned by a PackedStore
};

}  // namespace ribbon_mapper
