// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/registration/plane_adjustment.hpp"
#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/trajectory_segment.hpp"
#include "modeler/ribbon/ribbon.hpp"

/// A scene of exact planes for the tests of the registration.
namespace ribbon_mapper::hall {

/// The floor (0), the wall at the left (1) and the wall ahead (2).
std::vector<PlaneLandmark> planes();

/// The robot's true pose at a line: it drives along x and turns left. Line -1 is at the origin.
Pose true_pose(int line);

/// The ribbons that the robot sees from a line: one on each of planes(), in that order. They lie
/// aslant, and half a metre or so apart from line to line.
std::vector<Ribbon> ribbons_of_line(int line);

/// The observations of ribbons_of_line() with ranges of 1 cm, each with its plane as candidate.
std::vector<PlaneObservation> observations_of_line(int line);

/// The segment of lines [0, lines) with exact odometry, default noise and both ends known.
TrajectorySegment segment(int lines);

/// A pose with all six degrees of freedom, different for each seed.
Pose any_pose(unsigned seed);

/// Random numbers within -1 .. 1, different for each seed.
Eigen::MatrixXd random_matrix(int rows, int columns, unsigned seed);

/// A well-conditioned covariance whose standard deviations are about `sigma`.
Matrix6 any_covariance(double sigma, unsigned seed);

/// The norm of the difference of two poses' matrices.
double difference(const Pose& a, const Pose& b);

/// The Jacobian of `value_at(error)` at zero by central differences.
template <typename Function>
Eigen::MatrixXd derivative_by_error(const Function& value_at, int unknowns) {
  constexpr double kStep = 1e-5;
  Eigen::MatrixXd derivative;
  for (int i = 0; i < unknowns; ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(unknowns, i);
    const Eigen::VectorXd column = (value_at(step) - value_at(-step)) / (2.0 * kStep);
    if (i == 0) derivative.resize(column.size(), unknowns);
    derivative.col(i) = column;
  }
  return derivative;
}

}  // namespace ribbon_mapper::hall
