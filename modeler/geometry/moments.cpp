// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/moments.hpp"

#include <Eigen/Eigenvalues>

namespace ribbon_mapper {
namespace {

using Symmetric = Eigen::Matrix3d;

Symmetric second_moments(const std::array<double, 10>& s) {
  Symmetric m;
  m << s[4], s[5], s[6], s[5], s[7], s[8], s[6], s[8], s[9];
  return m;
}

}  // namespace

Moments Moments::of(double weight, const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d m = weight * (covariance + mean * mean.transpose());
  Moments result;
  result.sums_ = {weight,  weight * mean.x(), weight * mean.y(), weight * mean.z(), m(0, 0),
                  m(0, 1), m(0, 2),           m(1, 1),           m(1, 2),           m(2, 2)};
  return result;
}

Eigen::Matrix3d Moments::covariance() const {
  const Eigen::Vector3d centre = mean();
  return second_moments(sums_) / weight() - centre * centre.transpose();
}

double Moments::mean_square_distance(const Eigen::Vector3d& normal, double d_m) const {
  const Eigen::Vector3d sum(sums_[1], sums_[2], sums_[3]);
  const double square = normal.dot(second_moments(sums_) * normal) + 2.0 * d_m * normal.dot(sum) +
                        d_m * d_m * weight();
  return std::max(0.0, square / weight());
}

void Moments::spread(const Eigen::Vector3d& offset) {
  const double x = offset.x(), y = offset.y(), z = offset.z();
  const std::array<double, 6> squares{x * x, x * y, x * z, y * y, y * z, z * z};
  for (std::size_t i = 0; i < 6; ++i) sums_[4 + i] += weight() * squares[i];
}

Moments Moments::transformed(const Pose& T) const {
  const Eigen::Vector3d sum(sums_[1], sums_[2], sums_[3]);
  const Eigen::Matrix3d R = T.linear();
  const Eigen::Vector3d t = T.translation();
  const Eigen::Vector3d rotated = R * sum;
  const Eigen::Matrix3d m = R * second_moments(sums_) * R.transpose() + rotated * t.transpose() +
                            t * (rotated + weight() * t).transpose();
  Moments result;
  const Eigen::Vector3d moved = rotated + weight() * t;
  result.sums_ = {weight(), moved.x(), moved.y(), moved.z(), m(0, 0),
                  m(0, 1),  m(0, 2),   m(1, 1),   m(1, 2),   m(2, 2)};
  return result;
}

PlaneFit fit_plane(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance());
  return {moments.mean(), solver.eigenvalues().cwiseMax(0.0), solver.eigenvectors()};
}

}  // namespace ribbon_mapper
