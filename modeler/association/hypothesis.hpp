// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/geometry/moments.hpp"
#include "modeler/geometry/plane_fit.hpp"
#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper {

/// Smallest cosine between the normals of ribbons and planes that were seen from the same side.
constexpr double kMinCosineOfSide = 0.5;

/// The membership of a ribbon in a hypothesis.
struct Member {
  std::uint32_t ribbon = 0;  ///< index of the ribbon
  float probability = 1.0F;  ///< membership() when it joined; weights its area in eq. 4
};

/// A plane hypothesis: ribbons of similar parameters and their common plane (section 4.3 of the
/// paper).
///
/// Deviation from the paper: eq. 4 averages the ribbons' parameters, weighted by area times
/// probability. Here the plane is the least-squares fit of the ribbons' points with these weights.
/// The points of all ribbons determine the normal far better than the mean of single normals.
class Hypothesis {
 public:
  /// Creates a hypothesis without ribbons.
  explicit Hypothesis(std::int64_t id_ = 0) : id(id_) {}

  /// Adds a ribbon and fits the plane again.
  void add(const PosedRibbon& ribbon, const Member& member);
  /// Adds all ribbons of another hypothesis and fits the plane again. Keeps the id.
  void absorb(const Hypothesis& other);

  /// Returns the unit normal, which points to the side that the plane was seen from.
  const Eigen::Vector3d& normal() const { return normal_; }
  /// Returns the offset d of the plane n.p + d = 0 [m].
  double d_m() const { return d_m_; }
  /// Returns the fit of the plane. Its normal may have the opposite sign of normal().
  const PlaneFit& fit() const { return fit_; }
  /// Returns the sum of the ribbons' areas, weighted by probability [m2].
  double area_m2() const { return moments_.weight(); }
  /// Returns the number of points of all ribbons.
  double points() const { return points_; }
  /// Returns the moments of all points, weighted by area times probability.
  const Moments& moments() const { return moments_; }
  /// Returns the ribbons in the order in which they joined.
  const std::vector<Member>& members() const { return members_; }
  /// Returns the distance of a point from the plane [m], positive on the side it was seen from.
  double signed_distance(const Eigen::Vector3d& point) const { return normal_.dot(point) + d_m_; }

  /// Returns the variance of the normal's tilt along a direction in the plane [rad2]; infinity if
  /// the points have no extent.
  double tilt_variance(const Eigen::Vector3d& direction) const;

  std::int64_t id;  ///< number of the hypothesis, in the order of creation

 private:
  void refit();

  Moments moments_;  // weighted by area times probability
  Eigen::Vector3d side_ = Eigen::Vector3d::Zero();
  double points_ = 0.0;
  std::vector<Member> members_;
  PlaneFit fit_;
  Eigen::Vector3d normal_ = Eigen::Vector3d::UnitZ();
  double d_m_ = 0.0;
};

/// Returns the smallest cosine between the normals of a ribbon and a plane that the gates may
/// accept: the widest gate about both axes.
double min_cosine(const AssociationGates& gates);

/// Returns the squared Mahalanobis distance of a ribbon from a plane, or nothing outside the gates.
/// Adds the squares of the distance of the centroid and of the tilts along and across the ribbon,
/// each in standard deviations (section 4.3 of the paper).
std::optional<double> square_sigmas(const PosedRibbon& ribbon, const Hypothesis& plane,
                                    const AssociationGates& gates);

/// Returns the probability that a ribbon at this squared distance belongs to the plane.
inline double membership(double square_sigmas) { return std::exp(-0.5 * square_sigmas); }

/// Returns true if two hypotheses are one plane within the gates: they are seen from the same side,
/// have the same direction, and the points of the smaller one lie on the plane of the larger one.
bool are_one_plane(const Hypothesis& larger, const Hypothesis& smaller,
                   const AssociationGates& gates);

}  // namespace ribbon_mapper
