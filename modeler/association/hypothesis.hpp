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
#include "modeler/observations/posed_ribbon.hpp"

namespace ribbon_mapper {

/// Ribbons and planes whose normals lie further apart than this were seen from another side.
constexpr double kMinCosineOfSide = 0.5;

/// A ribbon's part in a hypothesis.
struct Member {
  std::uint32_t ribbon = 0;  ///< index
  float probability = 1.0F;  ///< with which it joined, weighs its area in eq. 4
};

/// What ribbons of like parameters were aggregated into (section 4.3).
///
/// Eq. 4 takes the mean of the ribbons' parameters, weighted by area times probability. Here the
/// same weights go on the ribbons' points, of which the plane is the least-squares fit: the mean of
/// parameters would let a ribbon's weak normal count where the spread of all ribbons knows better.
class Hypothesis {
 public:
  explicit Hypothesis(std::int64_t id_) : id(id_) {}

  void add(const PosedRibbon& ribbon, const Member& member);
  void absorb(const Hypothesis& other);

  const Eigen::Vector3d& normal() const { return normal_; }  ///< towards the seen side
  double d_m() const { return d_m_; }
  const PlaneFit& fit() const { return fit_; }
  double area_m2() const { return moments_.weight(); }  ///< sum of ribbons' areas, weighted
  double points() const { return points_; }
  const Moments& moments() const { return moments_; }
  const std::vector<Member>& members() const { return members_; }
  double signed_distance(const Eigen::Vector3d& point) const { return normal_.dot(point) + d_m_; }

  /// Of the error of the normal's tilt in a direction in the plane [rad2].
  double tilt_variance(const Eigen::Vector3d& direction) const;

  std::int64_t id;  ///< in the order of creation; of two that merge, the older one's

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

/// Normals of what may be one plane have at least this cosine: the widest gate about both axes.
double min_cosine(const AssociationGates& gates);

/// How far a ribbon is from belonging to a plane: the square of its distance at the centroid and of
/// its tilts along and across, each in sigmas; nothing outside of the gates (section 4.3).
std::optional<double> square_sigmas(const PosedRibbon& ribbon, const Hypothesis& plane,
                                    const AssociationGates& gates);

/// The probability of that belonging.
inline double membership(double square_sigmas) { return std::exp(-0.5 * square_sigmas); }

/// True if two hypotheses are one plane within the gates: same side, same direction, and the points
/// of the smaller one on the plane of the larger one.
bool are_one_plane(const Hypothesis& larger, const Hypothesis& smaller,
                   const AssociationGates& gates);

}  // namespace ribbon_mapper
