// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Closed-form statistics of a set of points: weight, sum p and sum p p^T. Sets are united by
/// adding, moved rigidly by a few dozen multiplications, and need no points for either.
class Moments {
 public:
  static Moments of(double weight, const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance);

  void add(const Eigen::Vector3d& point) {
    const double x = point.x(), y = point.y(), z = point.z();
    // One by one, so that a running sum stays in registers.
    sums_[0] += 1.0;
    sums_[1] += x, sums_[2] += y, sums_[3] += z;
    sums_[4] += x * x, sums_[5] += x * y, sums_[6] += x * z;
    sums_[7] += y * y, sums_[8] += y * z, sums_[9] += z * z;
  }
  Moments& operator+=(const Moments& other) {
    vector() += other.vector();
    return *this;
  }
  Moments& operator-=(const Moments& other) {
    vector() -= other.vector();
    return *this;
  }
  Moments& operator*=(double weight) {
    vector() *= weight;
    return *this;
  }
  friend Moments operator+(const Moments& a, const Moments& b) {
    Moments sum;
    sum.vector() = a.vector() + b.vector();
    return sum;
  }
  friend Moments operator-(const Moments& a, const Moments& b) {
    Moments difference;
    difference.vector() = a.vector() - b.vector();
    return difference;
  }
  /// Every point becomes a pair at +-`offset` from it: what a line of points knows across itself.
  void spread(const Eigen::Vector3d& offset);

  double weight() const { return sums_[0]; }
  Eigen::Vector3d mean() const { return Eigen::Vector3d(sums_[1], sums_[2], sums_[3]) / sums_[0]; }
  /// Second moments about the mean, divided by the weight [m2].
  Eigen::Matrix3d covariance() const;
  /// The same without its lower half: xx, xy, xz, yy, yz, zz.
  std::array<double, 6> upper_covariance() const {
    const double share = 1.0 / sums_[0];
    const double x = share * sums_[1], y = share * sums_[2], z = share * sums_[3];
    return {share * sums_[4] - x * x, share * sums_[5] - x * y, share * sums_[6] - x * z,
            share * sums_[7] - y * y, share * sums_[8] - y * z, share * sums_[9] - z * z};
  }
  /// Mean square of the signed distances n.p + d [m2].
  double mean_square_distance(const Eigen::Vector3d& normal, double d_m) const;
  /// The same points in another frame.
  Moments transformed(const Pose& T_target_source) const;

 private:
  // As Eigen sees them, two at a time.
  using Vector = Eigen::Matrix<double, 10, 1>;
  Eigen::Map<Vector, Eigen::Aligned16> vector() {
    return Eigen::Map<Vector, Eigen::Aligned16>(sums_.data());
  }
  Eigen::Map<const Vector, Eigen::Aligned16> vector() const {
    return Eigen::Map<const Vector, Eigen::Aligned16>(sums_.data());
  }

  alignas(16) std::array<double, 10> sums_{};  // 1, x, y, z, xx, xy, xz, yy, yz, zz
};

inline Moments operator*(double weight, Moments moments) { return moments *= weight; }

/// Least-squares plane through weighted points: principal component analysis (section 4.1).
struct PlaneFit {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  /// Variances along the axes, ascending [m2]: across the plane, the smaller and the larger extent.
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, as `variances`

  Eigen::Vector3d normal() const { return axes.col(0); }  ///< either side
  double d_m() const { return -normal().dot(mean); }
};

/// Needs at least three points; the normal of fewer, or of points on one line, is arbitrary.
PlaneFit fit_plane(const Moments& moments);

/// When points are flat enough for a normal.
struct Flatness {
  double max_variance_m2;  ///< across the plane
  double min_width_ratio;  ///< the smaller extent's variance, in units of that across the plane
};

/// The normal of fit_plane(), for less than half the time of all three axes; none if the points are
/// not flat.
std::optional<Eigen::Vector3d> flat_normal(const Moments& moments, const Flatness& flatness);

}  // namespace ribbon_mapper
