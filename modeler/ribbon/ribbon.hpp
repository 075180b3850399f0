// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/geometry/moments.hpp"

namespace ribbon_mapper {

/// Mean of a few neighbouring points of a ribbon.
struct RibbonSample {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();  ///< in the frame of the acquisition pose
  float square_m2 = 0.0F;   ///< mean square distance of the points from the ribbon's plane
  std::uint32_t count = 0;  ///< points
};

/// A maximal run of successive points of one scan line that lie on one plane, estimated with the
/// line before and the line after (eq. 1). All geometry is in the frame of its acquisition pose and
/// is never edited.
struct Ribbon {
  std::uint32_t pose = 0;  ///< acquisition pose: index into the trajectory
  std::uint32_t first_beam = 0, last_beam = 0;
  /// Of its points on the middle line, spread across it by the base line of the three lines, so
  /// that their plane is the ribbon's.
  Moments moments;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< from three lines, towards the sensor
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();   ///< unit direction of the run
  double sigma_across_rad = 0.0;  ///< error of the normal about `along`
  double length_m = 0.0;
  double area_m2 = 0.0;  ///< sum of the surfel areas (eq. 2), capped
  std::vector<RibbonSample> samples;
};

}  // namespace ribbon_mapper
