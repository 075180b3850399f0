// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_landmarks.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/association/plane_map.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

// Landmarks are listed for one side of the index only: the directions of their ribbons are as
// uncertain as the poses.
constexpr int kAnySide = 0;

double tilt(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction) {
  return std::asin(std::min(1.0, std::abs(normal.dot(direction))));
}

std::vector<Hypothesis> hypotheses_of(const PosedObservations& observations,
                                      const std::vector<LineState>& lines,
                                      const SharedSettings& shared) {
  PlaneMap map(shared.bridged_gap_m, shared.gates);
  for (std::uint32_t i = 0; i < observations.ribbon_count(); ++i) {
    const PosedRibbon ribbon = observations.ribbon(i);
    if (lines[ribbon.ribbon->pose].is_localised) map.add(ribbon, i);
  }
  return map.merged_hypotheses();
}

/// The ribbons of a hypothesis without those of the segment that contributes the most.
std::size_t independent_ribbons(const Hypothesis& hypothesis, const PosedObservations& observations,
                                const std::vector<LineState>& lines) {
  std::map<std::uint32_t, std::size_t> ribbons_by_segment;
  std::size_t largest = 0;
  for (const Member& member : hypothesis.members()) {
    const auto& segment = lines[observations.ribbon(member.ribbon).ribbon->pose].localised_by;
    if (segment) largest = std::max(largest, ++ribbons_by_segment[*segment]);
  }
  return hypothesis.members().size() - largest;
}

}  // namespace

PlaneLandmarks::PlaneLandmarks(const PosedObservations& observations,
                               const std::vector<LineState>& lines,
                               const RegistrationConfig& config, const SharedSettings& shared)
    : config_(config), index_(shared.bridged_gap_m) {
  const auto min_ribbons = static_cast<std::size_t>(config.min_ribbons);
  for (const Hypothesis& hypothesis : hypotheses_of(observations, lines, shared)) {
    if (independent_ribbons(hypothesis, observations, lines) < min_ribbons) continue;
    add(hypothesis, observations);
  }
}

void PlaneLandmarks::add(const Hypothesis& hypothesis, const PosedObservations& observations) {
  const auto slot = static_cast<std::uint32_t>(landmarks_.size());
  index_.list(slot, 1 << kAnySide);
  for (const Member& member : hypothesis.members()) {
    index_.voxels_of(observations.ribbon(member.ribbon), voxels_);
    index_.enter(slot, voxels_);
  }
  const Eigen::Vector3d axis_u = hypothesis.fit().axes.col(2);
  landmarks_.push_back(
      {hypothesis.normal(), axis_u, hypothesis.normal().cross(axis_u), hypothesis.fit().mean});
}

std::vector<std::uint32_t> PlaneLandmarks::landmarks_near(const PosedRibbon& ribbon) {
  std::vector<std::uint32_t> landmarks;
  index_.voxels_of(ribbon, voxels_);
  index_.near(
      voxels_, kAnySide, [](std::uint32_t) { return true; }, landmarks);
  return landmarks;
}

bool PlaneLandmarks::fits_across(const PlaneObservation& observation, const Eigen::Vector3d& normal,
                                 const PoseBelief& belief) const {
  const Pose& T = belief.T_model_base;
  if (normal.dot(T.linear() * observation.normal) < kMinCosineOfSide) return false;
  const Eigen::Vector3d across = T.linear() * observation.across;
  const Eigen::Vector3d turn = across.cross(normal);
  const double variance = turn.dot(belief.covariance.bottomRightCorner<3, 3>() * turn);
  const double sigma = std::sqrt(std::max(0.0, variance));
  const double gate =
      config_.max_tilt_across_deg * kDegree + 2.0 * (sigma + observation.sigma_across_rad);
  return tilt(normal, across) < gate;
}

std::optional<PlaneLandmarks::Match> PlaneLandmarks::match_of(const PlaneObservation& observation,
                                                              const PoseBelief& belief) const {
  std::optional<Match> best, second;
  const Pose& T = belief.T_model_base;
  for (const std::uint32_t candidate : observation.candidates) {
    const PlaneLandmark& landmark = landmarks_[candidate];
    if (!fits_across(observation, landmark.normal, belief)) continue;
    const Eigen::Vector2d residual = residual_of(observation, landmark, T);
    const Eigen::Matrix<double, 2, 6> derivative =
        derivative_by_pose(observation, landmark.normal, T);
    Eigen::Matrix2d covariance = derivative * belief.covariance * derivative.transpose();
    covariance.diagonal() += observation.variances;
    const double square_sigmas = residual.dot(covariance.inverse() * residual);
    if (square_sigmas > config_.max_chi_square) continue;
    const Match match{candidate, square_sigmas, residual};
    if (!best || square_sigmas < best->square_sigmas)
      second = best, best = match;
    else if (!second || square_sigmas < second->square_sigmas)
      second = match;
  }
  // Two landmarks within two sigmas of the ranges are the same to the line's pose.
  const bool is_ambiguous =
      second && second->square_sigmas < best->square_sigmas + config_.min_chi_square_lead &&
      square(second->residual[0] - best->residual[0]) > 4.0 * observation.variances[0];
  return is_ambiguous ? std::nullopt : best;
}

std::vector<LandmarkMatch> PlaneLandmarks::matches(
    const std::vector<PlaneObservation>& observations, const PoseBelief& belief) const {
  std::vector<LandmarkMatch> result;
  for (const PlaneObservation& observation : observations) {
    if (const auto match = match_of(observation, belief)) {
      result.push_back({&observation, match->landmark});
    }
  }
  return result;
}

PoseInformation PlaneLandmarks::linearised(const std::vector<PlaneObservation>& observations,
                                           const PoseBelief& belief) const {
  PoseInformation result;
  result.T_model_base = belief.T_model_base;
  for (const PlaneObservation& observation : observations) {
    const auto match = match_of(observation, belief);
    if (!match) continue;
    const Eigen::Vector2d weights = robust_weight(match->square_sigmas, config_.robust_sigmas) *
                                    observation.variances.cwiseInverse();
    const Eigen::Matrix<double, 2, 6> derivative =
        derivative_by_pose(observation, landmarks_[match->landmark].normal, belief.T_model_base);
    result.matrix += derivative.transpose() * weights.asDiagonal() * derivative;
    result.vector -= derivative.transpose() * weights.asDiagonal() * match->residual;
  }
  return result;
}

PoseInformation PlaneLandmarks::measure(const std::vector<PlaneObservation>& observations,
                                        const PoseBelief& without_them) const {
  const PoseInformation first = linearised(observations, without_them);
  return linearised(observations, updated(without_them, first));
}

}  // namespace ribbon_mapper
