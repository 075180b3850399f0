// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/normals/three_lines.hpp"

namespace ribbon_mapper::bench {

/// A method that estimates the normals of the middle one of three lines.
struct NormalsPeer {
  std::string name;  ///< for the report
  /// Estimates the normals of all samples from points that are converted already.
  std::function<void()> run;
  std::size_t normals = 0;  ///< number of normals that one run estimates
  /// Returns the normal of a sample at a beam after a run, in odom and with either sign; NaN if
  /// there is none.
  std::function<Eigen::Vector3d(std::size_t sample, std::size_t beam)> normal_at;
};

/// Returns the value that stands for no normal: NaN.
inline Eigen::Vector3d no_normal() {
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

// All peers get the same samples, which must outlive the returned peers.

/// Returns our method.
std::vector<NormalsPeer> our_normals(const std::vector<NormalsInput>& samples,
                                     const ModelerConfig& config);

/// Returns PCL's estimation with different neighbourhoods: radius `neighbourhood_m` and twice that,
/// 30 nearest points, and our own neighbours without a search.
std::vector<NormalsPeer> pcl_normals(const std::vector<NormalsInput>& samples,
                                     double neighbourhood_m);

/// Returns PCL's estimation on an organised image of three rows.
std::vector<NormalsPeer> pcl_integral_image_normals(const std::vector<NormalsInput>& samples);

/// Returns CGAL's estimation with 30 nearest points.
std::vector<NormalsPeer> cgal_normals(const std::vector<NormalsInput>& samples);

}  // namespace ribbon_mapper::bench
