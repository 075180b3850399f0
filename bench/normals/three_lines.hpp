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

/// Three lines of the tour: the input of all rows that estimate normals.
struct NormalsInput {
  std::array<ScanLine, 3> lines;   ///< previous, middle, next
  std::vector<std::size_t> beams;  ///< of the middle line: those with a return
  std::vector<BeamRange> around;   ///< of each of these; size 0: no normal there
  std::vector<Surfel> surfels;     ///< that we estimate on it
  Eigen::Matrix3d R_map_odom = Eigen::Matrix3d::Identity();  ///< as it really was
  const RecordedLine* recorded = nullptr;                    ///< the recording's line in the middle

  /// Returns the three lines as the stages of the method take them.
  ThreeLines three_lines() const { return {lines[0], lines[1], lines[2]}; }
  /// Returns the middle line.
  const ScanLine& middle() const { return lines[1]; }
};

/// `count` of these, evenly over the tour; fewer of a short one.
std::vector<NormalsInput> sample_lines(const Recording& recording, const ModelerConfig& config,
                                       std::size_t count);

/// Covariances of the neighbourhoods of all beams: real input for a 3x3 eigen solve.
std::vector<Eigen::Matrix3d> covariances_of(const std::vector<NormalsInput>& samples);

/// Nanoseconds of one closed-form 3x3 eigen solve (Eigen's computeDirect) on these: the unit in
/// which the line pipeline is measured.
double eigen_solve_ns(const std::vector<Eigen::Matrix3d>& covariances);

}  // namespace ribbon_mapper::bench
