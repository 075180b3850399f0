// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// The weight of a set of points and the sums of p and p p^T over it [m, m2].
///
/// Sets are united by addition, and moved rigidly in closed form, without access to the points.
class Moments {
 public:
  /// Returns the moments of a set with this weight, mean [m] and covariance [m2].
  static Moments of(double weight, const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance);

  /// Adds a point [m] of weight 1.
  void add(const Eigen::Vector3d& point) {
    const double x = point.x(), y = point.y(), z = point.z();
    // Written out element by element, so that a running sum stays in registers.
    sums_[0] += 1.0;
    sums_[1] += x, sums_[2] += y, sums_[3] += z;
    sums_[4] += x * x, sums_[5] += x * y, sums_[6] += x * z;
    sums_[7] += y * y, sums_[8] += y * z, sums_[9] += z * z;
  }
  /// Adds the points of another set.
  Moments& operator+=(const Moments& other) {
    vector() += other.vector();
    return *this;
  }
  /// Removes the points of a subset.
  Moments& operator-=(const Moments& other) {
    vector() -= other.vector();
    return *this;
  }
  /// Scales the weight of each point.
  Moments& operator*=(double weight) {
    vector() *= weight;
    return *this;
  }
  /// Returns the moments of the union of two disjoint sets.
  friend Moments operator+(const Moments& a, const Moments& b) {
    Moments sum;
    sum.vector() = a.vector() + b.vector();
    return sum;
  }
  /// Returns the moments of `a` without its subset `b`.
  friend Moments operator-(const Moments& a, const Moments& b) {
    Moments difference;
    difference.vector() = a.vector() - b.vector();
    return difference;
  }
  /// Replaces each point by two points of half its weight, at +-`offset` [m] from it. Gives a line
  /// of points an extent across itself.
  void spread(const Eigen::Vector3d& offset);

  /// Returns the sum of the weights.
  double weight() const { return sums_[0]; }
  /// Returns the mean of the points [m]; not finite for an empty set.
  Eigen::Vector3d mean() const { return Eigen::Vector3d(sums_[1], sums_[2], sums_[3]) / sums_[0]; }
  /// Returns the second moments about the mean, divided by the weight [m2].
  Eigen::Matrix3d covariance() const;
  /// Returns the upper half of the covariance [m2]: xx, xy, xz, yy, yz, zz.
  std::array<double, 6> upper_covariance() const {
    const double share = 1.0 / sums_[0];
    const double x = share * sums_[1], y = share * sums_[2], z = share * sums_[3];
    return {share * sums_[4] - x * x, share * sums_[5] - x * y, share * sums_[6] - x * z,
            share * sums_[7] - y * y, share * sums_[8] - y * z, share * sums_[9] - z * z};
  }
  /// Returns the mean square of the distances n.p + d of the points from a plane [m2].
  double mean_square_distance(const Eigen::Vector3d& normal, double d_m) const;
  /// Returns the moments of the points in another frame.
  Moments transformed(const Pose& T_target_source) const;

 private:
  // Ten numbers as an aligned vector, so that Eigen processes two at a time.
  using Vector = Eigen::Matrix<double, 10, 1>;
  Eigen::Map<Vector, Eigen::Aligned16> vector() {
    return Eigen::Map<Vector, Eigen::Aligned16>(sums_.data());
  }
  Eigen::Map<const Vector, Eigen::Aligned16> vector() const {
    return Eigen::Map<const Vector, Eigen::Aligned16>(sums_.data());
  }

  alignas(16) std::array<double, 10> sums_{};  // 1, x, y, z, xx, xy, xz, yy, yz, zz
};

/// Returns the moments with the weight of each point scaled.
inline Moments operator*(double weight, Moments moments) { return moments *= weight; }

}  // namespace ribbon_mapper
