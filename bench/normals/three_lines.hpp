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

/// A full line buffer of a tour, the input of all normal estimations.
struct ThreeLines {
  LineBuffer buffer{0.0};             ///< the lines
  std::vector<std::size_t> beams;     ///< beams of the middle line with a return
  std::vector<Neighbourhood> around;  ///< neighbourhood of each; size 0 where there is no normal
  std::vector<Surfel> surfels;        ///< our surfels of the middle line
  Eigen::Matrix3d R_map_odom = Eigen::Matrix3d::Identity();  ///< true rotation
  const RecordedLine* middle = nullptr;                      ///< middle line in the recording
};

/// Returns up to `count` buffers, evenly distributed over the tour.
std::vector<ThreeLines> sample_buffers(const Recording& recording, const ModelerConfig& config,
                                       std::size_t count);

/// Returns the covariances of all neighbourhoods, realistic input for a 3x3 eigen solver.
std::vector<Eigen::Matrix3d> covariances_of(const std::vector<ThreeLines>& samples);

/// Returns the mean CPU time of a closed-form 3x3 eigen solve (Eigen's computeDirect) [ns], the
/// unit for times of the line pipeline.
double eigen_solve_ns(const std::vector<Eigen::Matrix3d>& covariances);

}  // namespace ribbon_mapper::bench
