// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "modeler/geometry/moments.hpp"

namespace ribbon_mapper {

/// A least-squares plane through weighted points: their principal component analysis (section 4.1
/// of the paper).
struct PlaneFit {
  /// Mean of the points [m].
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  /// Variances along the axes, ascending [m2]: across the plane, then along its smaller and its
  /// larger extent.
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();
  /// Unit axes as columns, in the order of `variances`.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /// Returns the unit normal. Its sign is arbitrary.
  Eigen::Vector3d normal() const { return axes.col(0); }
  /// Returns the offset d of the plane n.p + d = 0 [m].
  double d_m() const { return -normal().dot(mean); }
};

/// Fits a plane to at least three points. The normal of fewer points, or of points on one line, is
/// arbitrary.
PlaneFit fit_plane(const Moments& moments);

/// Limits within which points are flat enough to have a normal.
struct Flatness {
  double max_variance_m2;  ///< largest variance across the plane
  double min_width_ratio;  ///< smallest ratio of the smaller extent's variance to that across
};

/// Returns the normal of fit_plane(), or nothing if the points are not flat. Takes less than half
/// the time of fit_plane(), which also computes the other two axes.
std::optional<Eigen::Vector3d> flat_normal(const Moments& moments, const Flatness& flatness);

}  // namespace ribbon_mapper
