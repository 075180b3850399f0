// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_landmarks.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

constexpr double degree = M_PI / 180.0;

// Innovations of two numbers further out than this happen once in 300 times (chi square).
constexpr double gate_square_sigmas = 11.8;
// Planes are entered for one side only: their ribbons' directions are as uncertain as their poses.
constexpr int any_side = 0;

// Of two planes the likelier one must be e^2 times as likely, unless they lie within the noise.
constexpr double ambiguous_square_sigmas = 4.0;

double tilt(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) {
  return std::asin(std::min(1.0, std::abs(normal.dot(direction))));
}

}  // namespace

ReferencePlanes::ReferencePlanes(const PosedObservations& observations,
                                 const std::vector<char>& is_placed,
                                 const std::vector<std::int32_t>& witness,
                                 const ModelerConfig& config)
    : angle_gate_rad_(config.association.slam.angle_deg * degree),
      index_(config.surface.bridged_gap_m) {
  PlaneMap map(config.surface.bridged_gap_m, config.association.corrected);
  for (std::uint32_t i = 0; i < observations.ribbon_count(); ++i) {
    const PosedRibbon ribbon = observations.ribbon(i);
    if (is_placed[ribbon.ribbon->pose]) map.add(ribbon, i);
  }
  for (const Hypothesis& hypothesis : map.merged_hypotheses()) {
    const auto min_ribbons = static_cast<std::size_t>(config.assembly.min_ribbons);
    if (!is_witnessed(hypothesis, observations, witness, min_ribbons)) continue;
    enter(static_cast<std::uint32_t>(planes_.size()), hypothesis, observations);
    const Eigen::Vector3d axis_u = hypothesis.fit().axes.col(2);
    planes_.push_back(
        {hypothesis.normal(), axis_u, hypothesis.normal().cross(axis_u), hypothesis.fit().mean});
  }
}

bool ReferencePlanes::is_witnessed(const Hypothesis& hypothesis,
                                   const PosedObservations& observations,
                                   const std::vector<std::int32_t>& witness,
                                   std::size_t min_ribbons) {
  std::map<std::int32_t, std::size_t> ribbons;
  for (const Member& member : hypothesis.members()) {
    ++ribbons[witness[observations.ribbon(member.ribbon).ribbon->pose]];
  }
  std::size_t most = 0;
  for (const auto& [of, count] : ribbons) {
    if (of != kSure) most = std::max(most, count);
  }
  return hypothesis.members().size() >= most + min_ribbons;
}

void ReferencePlanes::enter(std::uint32_t slot, const Hypothesis& hypothesis,
                            const PosedObservations& observations) {
  index_.list(slot, 1 << any_side);
  for (const Member& member : hypothesis.members()) {
    index_.voxels_of(observations.ribbon(member.ribbon), voxels_);
    index_.enter(slot, voxels_);
  }
}

void ReferencePlanes::find_near(const PosedRibbon& ribbon, Sight& sight) {
  index_.voxels_of(ribbon, voxels_);
  const auto all = [](std::uint32_t) { return true; };
  index_.near(voxels_, any_side, all, sight.planes);
}

bool ReferencePlanes::fits_across(const Sight& sight, const Eigen::Vector3d& normal,
                                  const PoseBelief& belief) const {
  const Pose& T = belief.T_model_base;
  if (normal.dot(T.linear() * sight.normal) < kMinCosineOfSide) return false;
  const Eigen::Vector3d across = T.linear() * sight.across;
  const Eigen::Vector3d turn = across.cross(normal);
  const double variance = turn.dot(belief.covariance.bottomRightCorner<3, 3>() * turn);
  const double sigma = std::sqrt(std::max(0.0, variance));
  const double gate = angle_gate_rad_ + 3.0 * degree + 2.0 * (sigma + sight.sigma_across_rad);
  return tilt(normal, across) < gate;
}

std::optional<ReferencePlanes::Match> ReferencePlanes::match_of(const Sight& sight,
                                                                const PoseBelief& belief) const {
  std::optional<Match> best, second;
  const Pose& T = belief.T_model_base;
  for (const std::uint32_t candidate : sight.planes) {
    const SightedPlane& plane = planes_[candidate];
    if (!fits_across(sight, plane.normal, belief)) continue;
    const Eigen::Vector2d residual = residual_of(sight, plane, T);
    const Eigen::Matrix<double, 2, 6> derivative = by_pose(sight, plane.normal, T);
    Eigen::Matrix2d covariance = derivative * belief.covariance * derivative.transpose();
    covariance.diagonal() += sight.variances;
    const double square_sigmas = residual.dot(covariance.inverse() * residual);
    if (square_sigmas > gate_square_sigmas) continue;
    Match match{candidate, square_sigmas, residual};
    if (!best || square_sigmas < best->square_sigmas)
      std::swap(best, second), best = match;
    else if (!second || square_sigmas < second->square_sigmas)
      second = match;
  }
  const bool is_ambiguous =
      second && second->square_sigmas < best->square_sigmas + ambiguous_square_sigmas &&
      square(second->residual[0] - best->residual[0]) > 4.0 * sight.variances[0];
  return is_ambiguous ? std::nullopt : best;
}

std::vector<PlaneSighting> ReferencePlanes::sightings(const std::vector<Sight>& sights,
                                                      const PoseBelief& belief) const {
  std::vector<PlaneSighting> result;
  for (const Sight& sight : sights) {
    if (const auto match = match_of(sight, belief)) result.push_back({&sight, match->plane});
  }
  return result;
}

Observation ReferencePlanes::linearised(const std::vector<Sight>& sights,
                                        const PoseBelief& belief) const {
  Observation result;
  result.T_model_base = belief.T_model_base;
  for (const Sight& sight : sights) {
    const auto match = match_of(sight, belief);
    if (!match) continue;
    const Eigen::Vector2d weights =
        robust_weight(match->square_sigmas) * sight.variances.cwiseInverse();
    const Eigen::Matrix<double, 2, 6> derivative =
        by_pose(sight, planes_[match->plane].normal, belief.T_model_base);
    result.information += derivative.transpose() * weights.asDiagonal() * derivative;
    result.gradient -= derivative.transpose() * weights.asDiagonal() * match->residual;
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
