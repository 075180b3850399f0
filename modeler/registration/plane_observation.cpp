// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_observation.hpp"

#include <cmath>

#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper {
namespace {

// The average time of a beam from the middle of its line, in intervals between lines.
constexpr double kMeanBeamOffset = 0.25;

/// The variance, along the normal, of a point that a motion of the base carries. All are in the
/// frame of the base.
double variance_along(const Eigen::Vector3d& normal, const Eigen::Vector3d& point,
                      const Vector6& variances) {
  return normal.cwiseAbs2().dot(variances.head<3>()) +
         point.cross(normal).cwiseAbs2().dot(variances.tail<3>());
}

/// Returns the variance of a ribbon's tilt across its direction by the base's motion from line to
/// line. `step_variance` is that of a point along the normal.
///
/// The slope of a straight line through three lines at -s, 0 and s, of which the outer ones were
/// moved, has the variance step_variance / 2 s2. The ribbon's moments hold 2/3 s2.
double tilt_variance_across(const PosedRibbon& ribbon, double step_variance) {
  const double base_line_square = ribbon.across.dot(ribbon.moments.covariance() * ribbon.across);
  return step_variance / (3.0 * base_line_square);
}

}  // namespace

PlaneObservation::PlaneObservation(const Ribbon& ribbon, const RangeNoise& noise,
                                   const Vector6& step_variances) {
  const PosedRibbon here(ribbon, Pose::Identity());
  centroid = here.centroid, normal = here.normal, along = here.along, across = here.across;
  const double step_variance = variance_along(normal, centroid, step_variances);
  sigma_across_rad =
      std::sqrt(square(ribbon.sigma_across_rad) + tilt_variance_across(here, step_variance));
  const double range_variance =
      square(noise.sigma_m) * (1.0 / here.moments.weight() + square(noise.shared_ratio));
  variances[0] = range_variance + kMeanBeamOffset * step_variance;
  // The slope of a straight line through points spread evenly over its length.
  variances[1] = 12.0 * range_variance / square(ribbon.length_m) +
                 kMeanBeamOffset * along.cross(normal).cwiseAbs2().dot(step_variances.tail<3>());
}

Eigen::Vector2d residual_of(const PlaneObservation& observation, const PlaneLandmark& landmark,
                            const Pose& T_model_base) {
  return {landmark.normal.dot(T_model_base * observation.centroid - landmark.centroid),
          landmark.normal.dot(T_model_base.linear() * observation.along)};
}

Eigen::Matrix<double, 2, 6> derivative_by_pose(const PlaneObservation& observation,
                                               const Eigen::Vector3d& normal,
                                               const Pose& T_model_base) {
  const Eigen::Vector3d lever = T_model_base.linear() * observation.centroid;
  const Eigen::Vector3d along = T_model_base.linear() * observation.along;
  Eigen::Matrix<double, 2, 6> derivative;
  derivative.row(0) << normal.transpose(), lever.cross(normal).transpose();
  derivative.row(1) << Eigen::RowVector3d::Zero(), along.cross(normal).transpose();
  return derivative;
}

Eigen::Matrix<double, 2, 3> derivative_by_landmark(const PlaneObservation& observation,
                                                   const PlaneLandmark& landmark,
                                                   const Pose& T_model_base) {
  const Eigen::Vector3d lever = T_model_base * observation.centroid - landmark.centroid;
  const Eigen::Vector3d along = T_model_base.linear() * observation.along;
  Eigen::Matrix<double, 2, 3> derivative;
  derivative << landmark.axis_u.dot(lever), landmark.axis_v.dot(lever), -1.0,  //
      landmark.axis_u.dot(along), landmark.axis_v.dot(along), 0.0;
  return derivative;
}

PlaneLandmark moved(const PlaneLandmark& landmark, const Eigen::Vector3d& error) {
  PlaneLandmark result = landmark;
  result.centroid += error[2] * landmark.normal;
  result.normal =
      (landmark.normal + error[0] * landmark.axis_u + error[1] * landmark.axis_v).normalized();
  result.axis_u =
      (landmark.axis_u - landmark.axis_u.dot(result.normal) * result.normal).normalized();
  result.axis_v = result.normal.cross(result.axis_u);
  return result;
}

}  // namespace ribbon_mapper
