// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/reference_planes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

constexpr double degree = M_PI / 180.0;

// Innovations of two numbers further out than this happen once in 300 times (chi square).
constexpr double gate_square_sigmas = 11.8;
// Of two planes the likelier one must be e^2 times as likely, unless they lie within the noise.
constexpr double ambiguous_square_sigmas = 4.0;
// Part of a range's sigma that the points of a ribbon share (bias of a surface, of an angle).
constexpr double shared_part = 0.25;

double square(double x) { return x * x; }

double tilt(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) {
  return std::asin(std::min(1.0, std::abs(normal.dot(direction))));
}

/// A surface that is seen at this point moves by this with a motion of the base (in its frame).
double variance_along(const Eigen::Vector3d& normal, const Eigen::Vector3d& lever,
                      const Vector6& variances) {
  const Eigen::Vector3d turn = lever.cross(normal);
  return normal.cwiseAbs2().dot(variances.head<3>()) + turn.cwiseAbs2().dot(variances.tail<3>());
}

}  // namespace

Sight::Sight(const Ribbon& ribbon, double range_sigma_m, const Vector6& motion_variances)
    : sigma_across_rad(ribbon.sigma_across_rad) {
  const PosedRibbon here(ribbon, Pose::Identity());
  centroid = here.centroid, normal = here.normal, along = here.along, across = here.across;
  const double variance = square(range_sigma_m), points = here.moments.weight();
  const Eigen::Vector3d turn = along.cross(normal);
  distance_variance = variance / points + square(shared_part) * variance +
                      variance_along(normal, centroid, motion_variances);
  // Of a straight line through points spread evenly over its length.
  tilt_variance = 12.0 * (variance / points + square(shared_part) * variance) /
                      square(ribbon.length_m) +
                  turn.cwiseAbs2().dot(motion_variances.tail<3>());
}

Jacobian jacobian_of(const Sight& sight, const Eigen::Vector3d& normal, const Pose& T_world_base) {
  const Eigen::Vector3d lever = T_world_base.linear() * sight.centroid;
  const Eigen::Vector3d along = T_world_base.linear() * sight.along;
  Jacobian jacobian;
  jacobian << normal.transpose(), lever.cross(normal).transpose(),
      Eigen::RowVector3d::Zero(), along.cross(normal).transpose();
  return jacobian;
}

ReferencePlanes::ReferencePlanes(const Evidence& evidence, const std::vector<char>& is_placed,
                                 const PlaneMapConfig& config)
    : angle_gate_rad_(config.slam.angle_deg * degree), index_(config.bridged_gap_m) {
  PlaneMap map(config, config.corrected);
  for (std::uint32_t i = 0; i < evidence.ribbon_count(); ++i) {
    const PosedRibbon ribbon = evidence.ribbon(i);
    if (is_placed[ribbon.ribbon->pose]) map.add(ribbon, i);
  }
  for (const Hypothesis& hypothesis : map.merged_hypotheses()) {
    if (hypothesis.members().size() < static_cast<std::size_t>(config.confirmed_ribbons)) continue;
    enter(static_cast<std::uint32_t>(planes_.size()), hypothesis, evidence);
    planes_.push_back({hypothesis.normal(), hypothesis.d_m()});
  }
}

void ReferencePlanes::enter(std::uint32_t slot, const Hypothesis& hypothesis,
                            const Evidence& evidence) {
  for (const Member& member : hypothesis.members()) {
    index_.voxels_of(evidence.ribbon(member.ribbon), voxels_);
    index_.enter(slot, voxels_);
  }
}

void ReferencePlanes::find_near(const PosedRibbon& ribbon, Sight& sight) {
  index_.voxels_of(ribbon, voxels_);
  index_.near(voxels_, sight.planes);
}

bool ReferencePlanes::fits_across(const Sight& sight, const Eigen::Vector3d& normal,
                                  const PoseBelief& belief) const {
  const Pose& T = belief.T_world_base;
  if (normal.dot(T.linear() * sight.normal) < least_cosine_of_side) return false;
  const Eigen::Vector3d across = T.linear() * sight.across;
  const Eigen::Vector3d turn = across.cross(normal);
  const double sigma =
      std::sqrt(turn.dot(belief.covariance.bottomRightCorner<3, 3>() * turn));
  const double gate = angle_gate_rad_ + 3.0 * degree + 2.0 * (sigma + sight.sigma_across_rad);
  return tilt(normal, across) < gate;
}

std::vector<ReferencePlanes::Match> ReferencePlanes::matches_of(const Sight& sight,
                                                                const PoseBelief& belief) const {
  std::vector<Match> matches;
  const Pose& T = belief.T_world_base;
  for (const std::uint32_t candidate : sight.planes) {
    const OrientedPlane& plane = planes_[candidate];
    if (!fits_across(sight, plane.normal, belief)) continue;
    const Eigen::Vector2d residual(plane.normal.dot(T * sight.centroid) + plane.d_m,
                                   plane.normal.dot(T.linear() * sight.along));
    const Jacobian jacobian = jacobian_of(sight, plane.normal, T);
    Eigen::Matrix2d covariance = jacobian * belief.covariance * jacobian.transpose();
    covariance.diagonal() += Eigen::Vector2d(sight.distance_variance, sight.tilt_variance);
    const double square_sigmas = residual.dot(covariance.inverse() * residual);
    if (square_sigmas < gate_square_sigmas) matches.push_back({candidate, square_sigmas, residual});
  }
  std::sort(matches.begin(), matches.end(), [](const Match& a, const Match& b) {
    return a.square_sigmas < b.square_sigmas;
  });
  return matches;
}

Observation ReferencePlanes::linearised(const std::vector<Sight>& sights,
                                        const PoseBelief& belief) const {
  Observation result;
  result.T_world_base = belief.T_world_base;
  for (const Sight& sight : sights) {
    const std::vector<Match> matches = matches_of(sight, belief);
    if (matches.empty()) continue;
    const Match& best = matches.front();
    const bool is_ambiguous =
        matches.size() > 1 &&
        matches[1].square_sigmas < best.square_sigmas + ambiguous_square_sigmas &&
        square(matches[1].residual[0] - best.residual[0]) > 4.0 * sight.distance_variance;
    if (is_ambiguous) continue;
    // Of Cauchy: what is four square sigmas out counts for half.
    const double weight = 1.0 / (1.0 + best.square_sigmas / 4.0);
    const Eigen::Vector2d information = weight * Eigen::Vector2d(1.0 / sight.distance_variance,
                                                                 1.0 / sight.tilt_variance);
    const Jacobian jacobian =
        jacobian_of(sight, planes_[best.plane].normal, belief.T_world_base);
    result.information += jacobian.transpose() * information.asDiagonal() * jacobian;
    result.gradient -= jacobian.transpose() * information.asDiagonal() * best.residual;
  }
  return result;
}

Observation ReferencePlanes::observe(const std::vector<Sight>& sights,
                                     const PoseBelief& without_them) const {
  // Once within the wide gates of where the line may be, and again from where that has put it.
  const Observation first = linearised(sights, without_them);
  return linearised(sights, updated(without_them, first));
}

}  // namespace ribbon_mapper
