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

/// A way to estimate the normals of the middle of three lines.
struct NormalsPeer {
  std::string name;
  /// Does the work on all samples, from points to normals; their conversion is not part of it.
  std::function<void()> run;
  std::size_t normals = 0;  ///< that one run estimates
  /// Of sample s at beam b, after a run, as far as there is one: in odom, either side. NaN if not.
  std::function<Eigen::Vector3d(std::size_t sample, std::size_t beam)> normal_at;
};

inline Eigen::Vector3d no_normal() {
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

// All peers are given the same three lines. They must outlive what is returned.
std::vector<NormalsPeer> our_normals(const std::vector<NormalsInput>& samples,
                                     const ModelerConfig& config);
/// Within a radius of the neighbourhood [m], of twice that, of 30 points; and without a search.
std::vector<NormalsPeer> pcl_normals(const std::vector<NormalsInput>& samples,
                                     double neighbourhood_m);
std::vector<NormalsPeer> pcl_integral_image_normals(const std::vector<NormalsInput>& samples);
std::vector<NormalsPeer> cgal_normals(const std::vector<NormalsInput>& samples);

}  // namespace ribbon_mapper::bench
