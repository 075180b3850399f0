// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/moments.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {

/// Returns the matrix of the second moments about the origin.
Eigen::Matrix3d second_moments(const std::array<double, 10>& s) {
  Eigen::Matrix3d m;
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
  const std::array<double, 6> c = upper_covariance();
  Eigen::Matrix3d m;
  m << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return m;
}

double Moments::mean_square_distance(const Eigen::Vector3d& normal, double d_m) const {
  const double x = normal.x(), y = normal.y(), z = normal.z();
  const auto& s = sums_;
  const double squares =
      x * (x * s[4] + 2.0 * (y * s[5] + z * s[6])) + y * (y * s[7] + 2.0 * z * s[8]) + z * z * s[9];
  const double square = squares + 2.0 * d_m * (x * s[1] + y * s[2] + z * s[3]) + d_m * d_m * s[0];
  return std::max(0.0, square / s[0]);
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

}  // namespace ribbon_mapper
