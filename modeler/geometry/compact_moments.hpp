// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "modeler/geometry/moments.hpp"

namespace ribbon_mapper {

/// Moments at rest: weight, mean and covariance in half the memory. Single precision is enough
/// about the mean, where it is not about a far origin.
class CompactMoments {
 public:
  CompactMoments() = default;
  CompactMoments(const Moments& moments);  // NOLINT(google-explicit-constructor): the same set

  double weight() const { return weight_; }
  Eigen::Vector3d mean() const { return mean_.cast<double>(); }
  Eigen::Matrix3d covariance() const;
  /// The same points, moved, ready for being added up.
  Moments transformed(const Pose& T_target_source) const;

 private:
  float weight_ = 0.0F;
  Eigen::Vector3f mean_ = Eigen::Vector3f::Zero();
  std::array<float, 6> covariance_{};  // xx, xy, xz, yy, yz, zz [m2]
};

}  // namespace ribbon_mapper
