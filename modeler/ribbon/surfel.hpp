// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/ribbon/ribbon_config.hpp"
#include "modeler/scan/beam_range.hpp"
#include "modeler/scan/three_lines.hpp"

namespace ribbon_mapper {

/// A point of the middle line with the normal of its plane (eq. 3) and the area that it stands for
/// (eq. 2), in the odom frame.
struct Surfel {
  std::uint32_t beam = 0;                             ///< index of the beam it is centred on
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< mean of the neighbours on the middle line
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit normal, towards the sensor
  double area_m2 = 0.0;  ///< capped area; see RibbonConfig::area_cap_m2
};

/// Returns the beams around `beam`, up to `half_length_m` to either side, within which all three
/// lines see one surface as far as jumps in depth tell. Empty if there are too few.
BeamRange neighbourhood_of(const ThreeLines& lines, std::size_t beam, double half_length_m);

/// Returns the area of one beam's surfel [m2]: 4 rho^2 sin(dpi/2) sin(dtheta/2) (eq. 2).
///
/// The step dpi between lines is measured at this very beam, as it shrinks towards the tilt axis
/// and at reversals.
double surfel_area_m2(const ThreeLines& lines, std::size_t beam);

/// Returns the sum of the beams' surfel areas, each counted with at most `cap_m2` [m2].
double capped_area_m2(const ThreeLines& lines, const BeamRange& beams, double cap_m2);

/// Estimates surfels of the middle line in the order of its beams. There is one for every few
/// beams, so that neighbourhoods overlap by more than half. `surfels` is overwritten and keeps its
/// capacity.
void estimate_surfels(const ThreeLines& lines, const ScanConfig& scan, const RibbonConfig& config,
                      std::vector<Surfel>& surfels);

}  // namespace ribbon_mapper
