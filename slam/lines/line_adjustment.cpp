// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/line_adjustment.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"
#include "modeler/registration/plane_adjustment.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Returns a belief at a pose whose gates are two standard deviations.
PoseBelief belief_within(const Pose& T_start_base, const AssociationGates& gates) {
  const double distance = square(0.5 * gates.distance_m);
  const double angle = square(0.5 * gates.angle_deg * kDegree);
  PoseBelief belief{T_start_base, Matrix6::Zero()};
  belief.covariance.diagonal() << distance, distance, distance, angle, angle, angle;
  return belief;
}

/// Returns a covariance that is narrower than two others: nearly the narrower one where they differ
/// much, half of both where they are equal, and zero where one of them is.
Matrix6 narrower_of(const Matrix6& a, const Matrix6& b) { return a * (a + b).ldlt().solve(b); }

/// Returns the variances of one of some steps that may be wrong together by any amount in the
/// plane.
Vector6 slip_variances(std::uint32_t steps) {
  Vector6 variances = Vector6::Zero();
  variances[0] = variances[1] = variances[5] = 1.0 / steps;
  return variances;
}

class Adjustment {
 public:
  Adjustment(const PosedLines& lines, const AdjustedLines& which, const OdometryNoise& noise,
             const EstimateSettings& settings);
  std::vector<ObservingLine> adjusted(const AssociationGates& gates);
  std::vector<Matrix6> covariances(const AssociationGates& gates);

 private:
  /// A ribbon of the context that lies at no known plane.
  struct LooseRibbon {
    std::uint32_t ribbon;
    std::size_t line;  // in the context
    const PlaneObservation* observation;
  };
  /// What is adjusted in a round.
  struct Round {
    std::vector<PlaneLandmark> landmarks;
    std::vector<ObservingLine> context;
    std::vector<ObservingSegment> segments;  // one, of the adjusted lines
    std::vector<std::uint32_t> others;       // ribbons of these lines that lie at no known plane
    std::vector<ObservingLine>& lines() { return segments.front().lines; }
    const std::vector<ObservingLine>& lines() const { return segments.front().lines; }
  };

  void list_context(const OdometryNoise& noise, const RangeNoise& ranges);
  Round matched(const AssociationGates& gates);
  TrajectorySegment segment() const;
  std::vector<Matrix6> step_information() const;
  PoseBelief belief_at(std::uint32_t line, const AssociationGates& gates) const;
  void match_with_known(std::uint32_t line, const AssociationGates& gates, Round& round);
  PlaneMap map_of_others(const AssociationGates& gates, const Round& round) const;
  void match_others(const AssociationGates& gates, Round& round) const;
  const PlaneObservation& observation_of(std::uint32_t ribbon) const;
  std::size_t index_of(std::uint32_t line) const { return line - which_.first; }

  const PosedLines& lines_;
  const AdjustedLines& which_;
  const EstimateSettings& settings_;
  const OdometryNoise& noise_;
  KnownPlanes known_;
  std::vector<std::vector<PlaneObservation>> of_context_;  // by line of the context
  std::vector<ObservingLine> context_;                     // with matches of known planes
  std::vector<LooseRibbon> loose_;                         // in the order of the ribbons
  std::vector<std::vector<PlaneObservation>> of_lines_;    // by adjusted line
};

Adjustment::Adjustment(const PosedLines& lines, const AdjustedLines& which,
                       const OdometryNoise& noise, const EstimateSettings& settings)
    : lines_(lines),
      which_(which),
      settings_(settings),
      noise_(noise),
      known_(lines, which.context, settings.estimate.gates.back(), settings) {
  const RangeNoise ranges = settings.range_noise();
  list_context(noise, ranges);
  for (std::uint32_t i = which.first; i < which.end; ++i) {
    of_lines_.push_back(lines.measured(i, noise, ranges));
  }
}

void Adjustment::list_context(const OdometryNoise& noise, const RangeNoise& ranges) {
  const AssociationGates& exact = settings_.estimate.gates.back();
  std::vector<std::uint32_t> plane_of(lines_.first_ribbon(which_.first), kNone);
  for (std::uint32_t plane = 0; plane < known_.planes().size(); ++plane) {
    for (const Member& member : known_.planes()[plane].members()) plane_of[member.ribbon] = plane;
  }
  for (const std::uint32_t line : which_.context) {
    of_context_.push_back(lines_.measured(line, noise, ranges));
    context_.push_back({lines_.T_start_base(line), {}});
    const PoseBelief belief = belief_within(lines_.T_start_base(line), exact);
    const std::uint32_t first = lines_.first_ribbon(line);
    for (std::uint32_t i = first; i < lines_.first_ribbon(line + 1); ++i) {
      PlaneObservation& observation = of_context_.back()[i - first];
      if (plane_of[i] != kNone) {
        context_.back().matches.push_back({&observation, plane_of[i]});
        continue;
      }
      observation.candidates = known_.landmarks().landmarks_near(lines_.posed_ribbon(i));
      if (!known_.landmarks().lies_at_candidate(observation, belief))
        loose_.push_back({i, context_.size() - 1, &observation});
    }
  }
}

TrajectorySegment Adjustment::segment() const {
  TrajectorySegment segment;
  segment.first_line = which_.first, segment.end_line = which_.end;
  for (std::uint32_t i = which_.first; i < which_.end; ++i) segment.steps.push_back(lines_.step(i));
  segment.steps.push_back(Pose::Identity());  // the end is open
  set_step_variances(noise_, segment);
  for (std::uint32_t i = which_.first; i < which_.end; ++i) {
    if (lines_.is_slip(i))
      segment.step_variances[index_of(i)] += slip_variances(lines_.slip_length(i));
  }
  segment.T_frame_start = lines_.T_start_base(which_.first - 1);
  return segment;
}

/// Returns the information of the steps if they are not those of the recorded odometry.
std::vector<Matrix6> Adjustment::step_information() const {
  std::vector<Matrix6> information;
  if (!lines_.has_source()) return information;
  for (std::uint32_t i = which_.first; i < which_.end; ++i) {
    Matrix6 covariance = lines_.fused_covariance(i, noise_);
    if (lines_.is_slip(i)) covariance.diagonal() += slip_variances(lines_.slip_length(i));
    information.push_back(covariance.inverse());
  }
  information.push_back(Matrix6::Identity());  // the end is open
  return information;
}

/// Returns the belief at a line's pose in a round: twice as uncertain as it was tracked, and no
/// more than the gates of the round say.
PoseBelief Adjustment::belief_at(std::uint32_t line, const AssociationGates& gates) const {
  PoseBelief belief = belief_within(lines_.T_start_base(line), gates);
  const std::size_t newer = which_.end - line;
  if (newer > which_.tracked.size()) return belief;
  const Matrix6 least =
      belief_within(belief.T_model_base, settings_.estimate.gates.back()).covariance;
  const Matrix6 tracked = 4.0 * which_.tracked[which_.tracked.size() - newer];
  belief.covariance = least + narrower_of(belief.covariance - least, tracked);
  return belief;
}

/// Matches the ribbons of a line with the known planes, and lists those that lie at none. One that
/// lies at a known plane and does not match it is too noisy to make a new plane.
void Adjustment::match_with_known(std::uint32_t line, const AssociationGates& gates, Round& round) {
  const PoseBelief belief = belief_at(line, gates);
  const std::uint32_t first = lines_.first_ribbon(line);
  std::vector<PlaneObservation>& observations = of_lines_[index_of(line)];
  for (std::uint32_t i = 0; i < observations.size(); ++i) {
    PlaneObservation& observation = observations[i];
    observation.candidates = known_.landmarks().landmarks_near(lines_.posed_ribbon(first + i));
    if (!known_.landmarks().lies_at_candidate(observation, belief))
      round.others.push_back(first + i);
  }
  round.lines().push_back({belief.T_model_base, known_.landmarks().matches(observations, belief)});
}

/// Returns the planes of all ribbons that lie at no known plane.
PlaneMap Adjustment::map_of_others(const AssociationGates& gates, const Round& round) const {
  PlaneMap map(settings_.shared.bridged_gap_m, gates);
  for (const LooseRibbon& loose : loose_) {
    map.add({lines_.ribbon(loose.ribbon), context_[loose.line].T_model_base}, loose.ribbon);
  }
  for (const std::uint32_t ribbon : round.others) map.add(lines_.posed_ribbon(ribbon), ribbon);
  return map;
}

const PlaneObservation& Adjustment::observation_of(std::uint32_t ribbon) const {
  const std::uint32_t line = lines_.ribbon(ribbon).pose;
  return of_lines_[index_of(line)][ribbon - lines_.first_ribbon(line)];
}

void Adjustment::match_others(const AssociationGates& gates, Round& round) const {
  const auto min_ribbons = static_cast<std::size_t>(settings_.registration.min_ribbons);
  for (const Hypothesis& plane : map_of_others(gates, round).merged_hypotheses()) {
    if (plane.members().size() < min_ribbons) continue;
    const auto landmark = static_cast<std::uint32_t>(round.landmarks.size());
    round.landmarks.push_back(landmark_of(plane));
    for (const Member& member : plane.members()) {
      const std::uint32_t line = lines_.ribbon(member.ribbon).pose;
      if (line >= which_.first) {
        round.lines()[index_of(line)].matches.push_back({&observation_of(member.ribbon), landmark});
        continue;
      }
      const auto loose = std::lower_bound(
          loose_.begin(), loose_.end(), member.ribbon,
          [](const LooseRibbon& a, std::uint32_t ribbon) { return a.ribbon < ribbon; });
      round.context[loose->line].matches.push_back({loose->observation, landmark});
    }
  }
}

/// Matches all ribbons with the planes of the context and with those of the others.
Adjustment::Round Adjustment::matched(const AssociationGates& gates) {
  Round round{known_.landmarks().all(), context_, {{segment(), {}, step_information()}}, {}};
  for (std::uint32_t i = which_.first; i < which_.end; ++i) {
    match_with_known(i, gates, round);
  }
  match_others(gates, round);
  return round;
}

/// Returns the lines at their poses after a round.
std::vector<ObservingLine> Adjustment::adjusted(const AssociationGates& gates) {
  Round round = matched(gates);
  for (int i = 0; i < settings_.estimate.steps_per_round; ++i) {
    adjust(round.context, round.segments, round.landmarks, settings_.registration.robust_sigmas);
  }
  return std::move(round.lines());
}

std::vector<Matrix6> Adjustment::covariances(const AssociationGates& gates) {
  const Round round = matched(gates);
  return pose_covariances(round.context, round.segments, round.landmarks,
                          settings_.registration.robust_sigmas);
}

}  // namespace

void adjust_lines(PosedLines& lines, const AdjustedLines& which, const OdometryNoise& noise,
                  const EstimateSettings& settings) {
  if (which.first >= which.end) return;
  Adjustment adjustment(lines, which, noise, settings);
  for (const AssociationGates& gates : settings.estimate.gates) {
    std::size_t i = which.first;
    for (const ObservingLine& line : adjustment.adjusted(gates)) {
      lines.set_pose(i++, line.T_model_base);
    }
  }
}

std::vector<Matrix6> line_covariances(const PosedLines& lines, const AdjustedLines& which,
                                      const OdometryNoise& noise,
                                      const EstimateSettings& settings) {
  if (which.first >= which.end) return {};
  return Adjustment(lines, which, noise, settings).covariances(settings.estimate.gates.back());
}

}  // namespace ribbon_mapper::slam
