// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/surface.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

/// Returns the covariance of the plane; see Plane::covariance. The errors of a ribbon's points are
/// dominated by the common error of its pose, so a ribbon counts as one measurement of its mean.
Eigen::Matrix3d covariance_of(const Hypothesis& hypothesis, const Plane& plane) {
  const Eigen::Matrix3d spread = hypothesis.moments().covariance();
  Eigen::Matrix<double, 3, 2> axes;
  axes << plane.axis_u, plane.axis_v;
  const Eigen::Matrix2d extent = axes.transpose() * spread * axes;
  const double variance =
      hypothesis.fit().variances[0] / static_cast<double>(hypothesis.members().size());
  const Eigen::Matrix2d slopes =
      variance * extent.inverse();  // covariance of d(height)/du and d(height)/dv
  Eigen::Matrix2d to_rotations;
  to_rotations << 0.0, 1.0, -1.0, 0.0;  // a slope along v is a rotation about u
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = to_rotations * slopes * to_rotations.transpose();
  covariance(2, 2) = variance;
  return covariance;
}

/// Returns the plane of a hypothesis, with its axes and without cells.
Plane frame_of(const Hypothesis& hypothesis, double cell_size_m) {
  Plane plane;
  plane.id = hypothesis.id;
  plane.cell_size_m = cell_size_m;
  plane.ribbons.reserve(hypothesis.members().size());
  for (const Member& member : hypothesis.members()) plane.ribbons.push_back(member.ribbon);
  plane.normal = hypothesis.normal();
  plane.d_m = hypothesis.d_m();
  plane.origin = -plane.d_m * plane.normal;
  const bool is_level = std::abs(plane.normal.z()) > 0.9;
  const Eigen::Vector3d other = is_level ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  plane.axis_u = other.cross(plane.normal).normalized();  // horizontal on walls
  plane.axis_v = plane.normal.cross(plane.axis_u);
  plane.covariance = covariance_of(hypothesis, plane);
  return plane;
}

}  // namespace

Surface::Surface(const Hypothesis& hypothesis, const PosedObservations& observations,
                 double cell_size_m)
    : plane_(frame_of(hypothesis, cell_size_m)), grid_(plane_) {
  const std::vector<Member>& members = hypothesis.members();
  const auto ribbon = [&](std::size_t i) {
    return members[std::min(i, members.size() - 1)].ribbon;
  };
  for (std::size_t i = 0; i < members.size(); ++i) {
    observations.prefetch(ribbon(i + 4), ribbon(i + 8));
    grid_.add(observations.samples(ribbon(i)));
  }
  refresh();
}

void Surface::refresh() {
  if (!std::is_sorted(plane_.ribbons.begin(), plane_.ribbons.end())) {
    std::sort(plane_.ribbons.begin(), plane_.ribbons.end());
  }
  plane_.cells = grid_.cells();
  const auto count = static_cast<double>(plane_.cells.size());
  plane_.area_m2 = count * plane_.cell_size_m * plane_.cell_size_m;
  double u = 0.0, v = 0.0;  // sums over cells
  for (const PlaneCell& cell : plane_.cells) u += cell.u, v += cell.v;
  plane_.centroid = plane_.origin + (u / count + 0.5) * plane_.cell_size_m * plane_.axis_u +
                    (v / count + 0.5) * plane_.cell_size_m * plane_.axis_v;
}

}  // namespace ribbon_mapper
