// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_observation.hpp"

#include "modeler/geometry/square.hpp"
#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper {
namespace {

/// Variance along the normal of a point that is moved by a motion of the base, in its frame.
double variance_along(const Eigen::Vector3d& normal, const Eigen::Vector3d& point,
                      const Vector6& variances) {
  return normal.cwiseAbs2().dot(variances.head<3>()) +
         point.cross(normal).cwiseAbs2().dot(variances.tail<3>());
}

}  // namespace

Sight::Sight(const Ribbon& ribbon, double range_sigma_m, const Vector6& motion_variances)
    : sigma_across_rad(ribbon.sigma_across_rad) {
  const PosedRibbon here(ribbon, Pose::Identity());
  centroid = here.centroid, normal = here.normal, along = here.along, across = here.across;
  const double range_variance =
      square(range_sigma_m) * (1.0 / here.moments.weight() + square(shared_part_of_sigma));
  variances[0] = range_variance + variance_along(normal, centroid, motion_variances);
  // Of a straight line through points spread evenly over its length.
  variances[1] = 12.0 * range_variance / square(ribbon.length_m) +
                 along.cross(normal).cwiseAbs2().dot(motion_variances.tail<3>());
}

Eigen::Vector2d residual_of(const Sight& sight, const SightedPlane& plane,
                            const Pose& T_model_base) {
  return {plane.normal.dot(T_model_base * sight.centroid - plane.centroid),
          plane.normal.dot(T_model_base.linear() * sight.along)};
}

Eigen::Matrix<double, 2, 6> by_pose(const Sight& sight, const Eigen::Vector3d& normal,
                                    const Pose& T_model_base) {
  const Eigen::Vector3d lever = T_model_base.linear() * sight.centroid;
  const Eigen::Vector3d along = T_model_base.linear() * sight.along;
  Eigen::Matrix<double, 2, 6> derivative;
  derivative.row(0) << normal.transpose(), lever.cross(normal).transpose();
  derivative.row(1) << Eigen::RowVector3d::Zero(), along.cross(normal).transpose();
  return derivative;
}

Eigen::Matrix<double, 2, 3> by_plane(const Sight& sight, const SightedPlane& plane,
                                     const Pose& T_model_base) {
  const Eigen::Vector3d lever = T_model_base * sight.centroid - plane.centroid;
  const Eigen::Vector3d along = T_model_base.linear() * sight.along;
  Eigen::Matrix<double, 2, 3> derivative;
  derivative << plane.axis_u.dot(lever), plane.axis_v.dot(lever), -1.0,  //
      plane.axis_u.dot(along), plane.axis_v.dot(along), 0.0;
  return derivative;
}

SightedPlane moved(const SightedPlane& plane, const Eigen::Vector3d& error) {
  SightedPlane result = plane;
  result.centroid += error[2] * plane.normal;
  result.normal = (plane.normal + error[0] * plane.axis_u + error[1] * plane.axis_v).normalized();
  result.axis_u = (plane.axis_u - plane.axis_u.dot(result.normal) * result.normal).normalized();
  result.axis_v = result.normal.cross(result.axis_u);
  return result;
}

}  // namespace ribbon_mapper
