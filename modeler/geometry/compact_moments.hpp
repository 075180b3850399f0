// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "modeler/geometry/moments.hpp"

namespace ribbon_mapper {

/// Moments for storage: weight, mean and covariance in single precision, in half the memory.
///
/// Single precision suffices for second moments about the mean, but not for those about the origin
/// of a large map.
class CompactMoments {
 public:
  /// Creates the moments of an empty set.
  CompactMoments() = default;
  /// Converts the moments of the same set.
  CompactMoments(const Moments& moments);  // NOLINT(google-explicit-constructor): the same set

  /// Weight, mean (x, y, z [m]) and covariance (xx, xy, xz, yy, yz, zz [m2]), as they are stored.
  using Numbers = std::array<float, 10>;
  /// Creates the moments of these numbers, bit by bit.
  static CompactMoments of(const Numbers& numbers);
  /// Returns all numbers, bit by bit.
  Numbers numbers() const;

  /// Returns the sum of the weights.
  double weight() const { return weight_; }
  /// Returns the mean of the points [m].
  Eigen::Vector3d mean() const { return mean_.cast<double>(); }
  /// Returns the covariance of the points [m2].
  Eigen::Matrix3d covariance() const;
  /// Returns the moments of the points in another frame, in double precision.
  Moments transformed(const Pose& T_target_source) const;

 private:
  float weight_ = 0.0F;
  Eigen::Vector3f mean_ = Eigen::Vector3f::Zero();
  std::array<float, 6> covariance_{};  // xx, xy, xz, yy, yz, zz [m2]
};

}  // namespace ribbon_mapper
