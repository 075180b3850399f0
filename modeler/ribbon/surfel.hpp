// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/ribbon/ribbon_config.hpp"
#include "modeler/scan/line_buffer.hpp"

namespace ribbon_mapper {

/// A point of the middle line with its normal, its plane's parameters (eq. 3) and the area that it
/// stands for (eq. 2). In the odom frame; the distance is taken from the sensor's origin.
struct Surfel {
  std::uint32_t beam = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< mean of the neighbourhood's middle line
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the sensor
  double area_m2 = 0.0;
};

/// Beams [begin, end) around `beam` within which all three lines see one surface, as far as
/// jumps in depth tell; empty if there is none.
struct Neighbourhood {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};
Neighbourhood neighbourhood_of(const LineBuffer& buffer, std::size_t beam, double half_length_m);

/// Area of one beam's surfel [m2]: 4 rho^2 sin(dpi/2) sin(dtheta/2) (eq. 2), with the step dpi
/// between the lines measured at this very beam, as it shrinks towards the tilt axis and at
/// reversals.
double surfel_area_m2(const LineBuffer& buffer, std::size_t beam);

/// Sum over beams, none of which counts for more than the cap [m2].
double capped_area_m2(const LineBuffer& buffer, const Neighbourhood& beams, double cap_m2);

/// Surfels of the middle line in the order of its beams, one for every few beams: neighbourhoods
/// overlap by more than half. `surfels` is overwritten and keeps its capacity.
void estimate_surfels(const LineBuffer& buffer, const ScanConfig& scan, const RibbonConfig& config,
                      std::vector<Surfel>& surfels);

}  // namespace ribbon_mapper
