// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "modeler/geometry/compact_moments.hpp"
#include "modeler/ribbon/ribbon_samples.hpp"

namespace ribbon_mapper {

/// A maximal run of successive points of one scan line that lie on one plane, estimated with the
/// line before and the line after (eq. 1). All geometry is in the frame of its acquisition pose and
/// is never edited. In single precision: a hundred thousand times finer than the sensor.
struct Ribbon {
  std::uint32_t pose = 0;  ///< acquisition pose: index into the trajectory
  std::uint32_t first_beam = 0, last_beam = 0;
  /// Of its points on the middle line, spread across it by the base line of the three lines, so
  /// that their plane is the ribbon's.
  CompactMoments spread;
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< from three lines, towards the sensor
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();   ///< unit direction of the run, in the plane
  float sigma_across_rad = 0.0F;                      ///< error of the normal about `along`
  float area_m2 = 0.0F;                               ///< sum of the surfel areas (eq. 2), capped
  float length_m = 0.0F;                              ///< from the first sample to the last
  RibbonSamples samples;  ///< of the points of the middle line; kept by a PackedStore
};

}  // namespace ribbon_mapper
