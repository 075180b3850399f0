// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "modeler/geometry/moments.hpp"

namespace ribbon_mapper {

/// Points of weight 1 [m].
using Points = std::vector<Eigen::Vector3d>;

/// Returns points that are normally distributed about `centre`, with these standard deviations
/// along rotated axes.
inline Points cloud(const Eigen::Vector3d& sigma, const Eigen::Vector3d& centre, int count,
                    int seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> unit;
  const Eigen::Matrix3d axes =
      Eigen::AngleAxisd(0.9, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  Points points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p(unit(random), unit(random), unit(random));
    points.push_back(centre + axes * sigma.cwiseProduct(p));
  }
  return points;
}

/// Returns the moments of points of weight 1.
inline Moments moments_of(const Points& points) {
  Moments moments;
  for (const Eigen::Vector3d& p : points) moments.add(p);
  return moments;
}

/// Returns the mean by its definition.
inline Eigen::Vector3d slow_mean(const Points& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  return sum / points.size();
}

/// Returns the covariance by its definition.
inline Eigen::Matrix3d slow_covariance(const Points& points) {
  const Eigen::Vector3d mean = slow_mean(points);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += (p - mean) * (p - mean).transpose();
  return sum / points.size();
}

}  // namespace ribbon_mapper
