// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "bench/recording/recording.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/ribbon/surfel.hpp"
#include "modeler/scan/three_lines.hpp"

namespace ribbon_mapper::bench {

/// Three lines of a tour, the input of all normal estimations.
struct NormalsInput {
  std::array<ScanLine, 3> lines;   ///< previous, middle, next
  std::vector<std::size_t> beams;  ///< beams of the middle line with a return
  std::vector<BeamRange> around;   ///< range of each; size 0 where there is no normal
  std::vector<Surfel> surfels;     ///< our surfels of the middle line
  Eigen::Matrix3d R_map_odom = Eigen::Matrix3d::Identity();  ///< true rotation
  const RecordedLine* recorded = nullptr;                    ///< middle line in the recording

  /// Returns the three lines as the method's stages take them.
  ThreeLines three_lines() const { return {lines[0], lines[1], lines[2]}; }

  /// Returns the middle line.
  const ScanLine& middle() const { return lines[1]; }
};

/// Returns up to `count` samples, evenly distributed over the tour.
std::vector<NormalsInput> sample_lines(const Recording& recording, const ModelerConfig& config,
                                       std::size_t count);

/// Returns the covariances of all neighbourhoods, realistic input for a 3x3 eigen solver.
std::vector<Eigen::Matrix3d> covariances_of(const std::vector<NormalsInput>& samples);

/// Returns the mean CPU time of a closed-form 3x3 eigen solve (Eigen's computeDirect) [ns], the
/// unit for times of the line pipeline.
double eigen_solve_ns(const std::vector<Eigen::Matrix3d>& covariances);

}  // namespace ribbon_mapper::bench
