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

std::vector<Hypothesis> supported_planes(const PosedObservations& observations,
                                         const std::vector<LineState>& lines,
                                         const RegistrationConfig& config,
                                         const SharedSettings& shared) {
  const auto min_ribbons = static_cast<std::size_t>(config.min_ribbons);
  std::vector<Hypothesis> supported;
  for (Hypothesis& plane : hypotheses_of(observations, lines, shared)) {
    if (independent_ribbons(plane, observations, lines) < min_ribbons) continue;
    supported.push_back(std::move(plane));
  }
  return supported;
}

PlaneLandmark landmark_of(const Hypothesis& plane) {
  const Eigen::Vector3d axis_u = plane.fit().axes.col(2);
  return {plane.normal(), axis_u, plane.normal().cross(axis_u), plane.fit().mean};
}

PlaneLandmarks::PlaneLandmarks(const std::vector<Hypothesis>& planes,
                               const std::function<PosedRibbon(std::uint32_t)>& ribbon_at,
                               double reach_m, const RegistrationConfig& config)
    : config_(config), index_(reach_m) {
  for (const Hypothesis& plane : planes) add(plane, ribbon_at);
}

void PlaneLandmarks::add(const Hypothesis& plane,
                         const std::function<PosedRibbon(std::uint32_t)>& ribbon_at) {
  const auto slot = static_cast<std::uint32_t>(landmarks_.size());
  index_.list(slot, 1 << kAnySide);
  for (const Member& member : plane.members()) {
    index_.voxels_of(ribbon_at(member.ribbon), voxels_);
    index_.enter(slot, voxels_);
  }
  landmarks_.push_back(landmark_of(plane));
}

void PlaneLandmarks::extend(std::uint32_t landmark, const PosedRibbon& ribbon) {
  index_.voxels_of(ribbon, voxels_);
  index_.enter(landmark, voxels_);
}

std::vector<std::uint32_t> PlaneLandmarks::landmarks_near(const PosedRibbon& ribbon) {
  std::vector<std::uint32_t> landmarks;
  index_.voxels_of(ribbon, voxels_);
  index_.near(
      voxels_, kAnySide, [](std::uint32_t) { return true; }, landmarks);
  return landmarks;
}

/// Returns how far a ribbon is tipped across its direction beyond what is tolerated, as the square
/// of standard deviations.
double LandmarkMatcher::square_sigmas_across(const PlaneObservation& observation,
                                             const Eigen::Vector3d& normal,
                                             const PoseBelief& belief) const {
  const Eigen::Vector3d across = belief.T_model_base.linear() * observation.across;
  const double excess = tilt(normal, across) - config_.max_tilt_across_deg * kDegree;
  if (excess <= 0.0) return 0.0;
  const Eigen::Vector3d turn = across.cross(normal);
  const double of_pose = turn.dot(belief.covariance.bottomRightCorner<3, 3>() * turn);
  return square(excess) / (std::max(0.0, of_pose) + square(observation.sigma_across_rad));
}

std::optional<LandmarkMatcher::Match> LandmarkMatcher::match_of(const PlaneObservation& observation,
                                                                const PoseBelief& belief) const {
  std::optional<Match> best, second;
  const Pose& T = belief.T_model_base;
  for (const std::uint32_t candidate : observation.candidates) {
    const PlaneLandmark& landmark = (*landmarks_)[candidate];
    if (landmark.normal.dot(T.linear() * observation.normal) < kMinCosineOfSide) continue;
    const Eigen::Vector2d residual = residual_of(observation, landmark, T);
    const Eigen::Matrix<double, 2, 6> derivative =
        derivative_by_pose(observation, landmark.normal, T);
    Eigen::Matrix2d covariance = derivative * belief.covariance * derivative.transpose();
    covariance.diagonal() += observation.variances;
    const double square_sigmas = residual.dot(covariance.inverse() * residual) +
                                 square_sigmas_across(observation, landmark.normal, belief);
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

bool LandmarkMatcher::lies_at_candidate(const PlaneObservation& observation,
                                        const PoseBelief& belief) const {
  const Pose& T = belief.T_model_base;
  return std::any_of(
      observation.candidates.begin(), observation.candidates.end(), [&](std::uint32_t candidate) {
        const PlaneLandmark& landmark = (*landmarks_)[candidate];
        if (landmark.normal.dot(T.linear() * observation.normal) < kMinCosineOfSide) return false;
        const Vector6 by_pose = derivative_by_pose(observation, landmark.normal, T).row(0);
        const double variance = by_pose.dot(belief.covariance * by_pose) + observation.variances[0];
        return square(residual_of(observation, landmark, T)[0]) < config_.max_chi_square * variance;
      });
}

std::vector<LandmarkMatch> LandmarkMatcher::matches(
    const std::vector<PlaneObservation>& observations, const PoseBelief& belief) const {
  std::vector<LandmarkMatch> result;
  for (const PlaneObservation& observation : observations) {
    if (const auto match = match_of(observation, belief)) {
      result.push_back({&observation, match->landmark});
    }
  }
  return result;
}

PoseInformation LandmarkMatcher::linearised(const std::vector<PlaneObservation>& observations,
                                            const PoseBelief& belief) const {
  PoseInformation result;
  result.T_model_base = belief.T_model_base;
  for (const PlaneObservation& observation : observations) {
    const auto match = match_of(observation, belief);
    if (!match) continue;
    const Eigen::Vector2d weights = robust_weight(match->square_sigmas, config_.robust_sigmas) *
                                    observation.variances.cwiseInverse();
    const Eigen::Matrix<double, 2, 6> derivative =
        derivative_by_pose(observation, (*landmarks_)[match->landmark].normal, belief.T_model_base);
    result.matrix += derivative.transpose() * weights.asDiagonal() * derivative;
    result.vector -= derivative.transpose() * weights.asDiagonal() * match->residual;
  }
  return result;
}

PoseInformation LandmarkMatcher::measure(const std::vector<PlaneObservation>& observations,
                                         const PoseBelief& without_them) const {
  const PoseInformation first = linearised(observations, without_them);
  return linearised(observations, updated(without_them, first));
}

}  // namespace ribbon_mapper
