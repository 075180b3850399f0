// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

/// Largest tolerance for the error of a normal, however short the base line.
constexpr double kMaxTolerance_rad = 3.0 * kDegree;

/// Returns the angle of a direction out of a plane [rad]. Takes the sine for the angle, to within
/// 0.2 % over the range of the gates.
double tilt(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) {
  return std::abs(normal.dot(direction));
}

/// Returns the tolerance that widens the angular gate: two standard deviations of a normal's error.
double tolerance_rad(double variance) {
  return std::min(kMaxTolerance_rad, 2.0 * std::sqrt(variance));
}

}  // namespace

void Hypothesis::add(const PosedRibbon& ribbon, const Member& member) {
  const double weight = ribbon.ribbon->area_m2 * member.probability;
  moments_ += (weight / ribbon.moments.weight()) * ribbon.moments;
  side_ += weight * ribbon.normal;
  points_ += ribbon.moments.weight();
  if (members_.empty()) members_.reserve(4);
  members_.push_back(member);
  refit();
}

void Hypothesis::absorb(const Hypothesis& other) {
  moments_ += other.moments_;
  side_ += other.side_;
  points_ += other.points_;
  members_.insert(members_.end(), other.members_.begin(), other.members_.end());
  refit();
}

void Hypothesis::refit() {
  fit_ = fit_plane(moments_);
  normal_ = fit_.normal().dot(side_) < 0.0 ? Eigen::Vector3d(-fit_.normal()) : fit_.normal();
  d_m_ = -normal_.dot(fit_.mean);
}

double Hypothesis::tilt_variance(const Eigen::Vector3d& direction) const {
  double square_sum = 0.0;
  for (int axis = 1; axis < 3; ++axis) {
    // No extent that is left, far from the origin, tells no tilt.
    if (fit_.variances[axis] <= 0.0) return std::numeric_limits<double>::infinity();
    square_sum += square(direction.dot(fit_.axes.col(axis))) / fit_.variances[axis];
  }
  return fit_.variances[0] / points_ * square_sum;
}

double min_cosine(const AssociationGates& gates) {
  const double sine = std::sin(std::min(M_PI_4, gates.angle_deg * kDegree + kMaxTolerance_rad));
  return std::max(kMinCosineOfSide, std::sqrt(1.0 - 2.0 * sine * sine));
}

std::optional<double> square_sigmas(const PosedRibbon& ribbon, const Hypothesis& plane,
                                    const AssociationGates& gates) {
  if (plane.normal().dot(ribbon.normal) < kMinCosineOfSide) return std::nullopt;
  const double distance = std::abs(plane.signed_distance(ribbon.centroid)) / gates.distance_m;
  if (distance > 1.0) return std::nullopt;
  const double gate = gates.angle_deg * kDegree;
  const double tilt_along = tilt(plane.normal(), ribbon.along);
  const double tilt_across = tilt(plane.normal(), ribbon.across);
  if (std::max(tilt_along, tilt_across) > gate + kMaxTolerance_rad) return std::nullopt;
  const double along = tilt_along / (gate + tolerance_rad(plane.tilt_variance(ribbon.along)));
  const double across =
      tilt_across / (gate + tolerance_rad(plane.tilt_variance(ribbon.across) +
                                          square(ribbon.ribbon->sigma_across_rad)));
  if (along > 1.0 || across > 1.0) return std::nullopt;
  // The gates are at two standard deviations.
  return 4.0 * (square(distance) + square(along) + square(across));
}

bool are_one_plane(const Hypothesis& larger, const Hypothesis& smaller,
                   const AssociationGates& gates) {
  if (larger.normal().dot(smaller.normal()) < kMinCosineOfSide) return false;
  if (std::abs(larger.signed_distance(smaller.fit().mean)) > gates.distance_m) return false;
  const double ms = smaller.moments().mean_square_distance(larger.normal(), larger.d_m());
  if (ms > square(gates.distance_m)) return false;
  for (int axis = 1; axis < 3; ++axis) {
    const Eigen::Vector3d direction = smaller.fit().axes.col(axis);
    const double variance = larger.tilt_variance(direction) + smaller.tilt_variance(direction);
    if (tilt(larger.normal(), direction) > gates.angle_deg * kDegree + tolerance_rad(variance)) {
      return false;
    }
  }
  return true;
}

}  // namespace ribbon_mapper
