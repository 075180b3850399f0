// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "bench/recording/recording.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/ribbon/surfel.hpp"
#include "modeler/scan/line_buffer.hpp"

namespace ribbon_mapper::bench {

/// A full buffer of the tour: the input of all rows that estimate normals.
struct ThreeLines {
  LineBuffer buffer{0.0};
  std::vector<std::size_t> beams;     ///< of the middle line: those with a return
  std::vector<Neighbourhood> around;  ///< of each of these; size 0: no normal there
  std::vector<Surfel> surfels;        ///< that we estimate on it
  Eigen::Matrix3d R_map_odom = Eigen::Matrix3d::Identity();  ///< as it really was
  const RecordedLine* middle = nullptr;                      ///< the recording's line in the middle
};

/// `count` buffers, evenly over the tour; fewer of a short one.
std::vector<ThreeLines> sample_buffers(const Recording& recording, const ModelerConfig& config,
                                       std::size_t count);

/// Covariances of the neighbourhoods of all beams: real input for a 3x3 eigen solve.
std::vector<Eigen::Matrix3d> covariances_of(const std::vector<ThreeLines>& samples);

/// Nanoseconds of one closed-form 3x3 eigen solve (Eigen's computeDirect) on these: the unit in
/// which the line pipeline is measured.
double eigen_solve_ns(const std::vector<Eigen::Matrix3d>& covariances);

}  // namespace ribbon_mapper::bench
