// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/line_adjustment.hpp"

#include <algorithm>
#include <limits>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"
#include "modeler/registration/plane_adjustment.hpp"

namespace ribbon_mapper::slam {
namespace {

/// The ribbons of some lines with the landmark of each.
struct Matches {
  std::vector<std::vector<PlaneObservation>> observations;  // by line
  std::vector<std::vector<LandmarkMatch>> matches;          // by line
};

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Adjustment {
 public:
  Adjustment(PosedLines& lines, const AdjustedLines& which, const OdometryNoise& noise,
             const EstimateSettings& settings)
      : lines_(lines),
        which_(which),
        noise_(noise),
        settings_(settings),
        ranges_{settings.shared.range_sigma_m, settings.registration.shared_sigma_ratio},
        known_(lines, which.context, settings.estimate.window_gates.back(), settings) {
    list_known_lines();
    for (std::uint32_t i = which.first; i < which.end; ++i) {
      observations_.push_back(lines.observations(i, noise, ranges_));
    }
  }

  void run_round(const AssociationGates& gates) {
    landmarks_ = known_.landmarks().all();
    std::vector<ObservingSegment> segments{{segment(), {}}};
    std::vector<ObservingLine>& observing = segments.front().lines;
    for (std::uint32_t i = which_.first; i < which_.end; ++i) observing.push_back(known_matches(i, gates));
    loose_lines_ = known_lines_;
    add_new_planes(gates, observing);
    for (int i = 0; i < settings_.estimate.steps_per_round; ++i) {
      adjust(loose_lines_, segments, landmarks_, settings_.registration.robust_sigmas);
    }
    for (std::uint32_t i = which_.first; i < which_.end; ++i) {
      lines_.set_pose(i, observing[i - which_.first].T_model_base);
    }
  }

 private:
  /// Lists the ribbons of the context with the known planes that they belong to.
  void list_known_lines() {
    std::vector<std::uint32_t> plane_of(lines_.ribbon_count(which_.first), kNone);
    for (std::uint32_t plane = 0; plane < known_.planes().size(); ++plane) {
      for (const Member& member : known_.planes()[plane].members()) plane_of[member.ribbon] = plane;
    }
    for (const std::uint32_t line : which_.context) {
      known_observations_.push_back(lines_.observations(line, noise_, ranges_));
      known_lines_.push_back({lines_.pose(line), {}});
      for (std::uint32_t i = lines_.first_ribbon(line); i < lines_.first_ribbon(line + 1); ++i) {
        const PlaneObservation& observation = known_observations_.back()[i - lines_.first_ribbon(line)];
        if (plane_of[i] != kNone) known_lines_.back().matches.push_back({&observation, plane_of[i]});
        else loose_.push_back({i, known_lines_.size() - 1, &observation});
      }
    }
  }

  TrajectorySegment segment() const {
    TrajectorySegment segment;
    segment.first_line = which_.first, segment.end_line = which_.end;
    for (std::uint32_t i = which_.first; i < which_.end; ++i) segment.steps.push_back(lines_.step(i));
    segment.steps.push_back(Pose::Identity());
    set_step_variances(noise_, segment);
    segment.T_frame_start = lines_.pose(which_.first - 1);
    return segment;
  }

  ObservingLine known_matches(std::uint32_t line, const AssociationGates& gates) {
    ObservingLine result{lines_.pose(line), {}};
    if (landmarks_.empty()) return result;
    PoseBelief belief{result.T_model_base, Matrix6::Zero()};
    const double distance = square(0.5 * gates.distance_m), angle = square(0.5 * gates.angle_deg * kDegree);
    belief.covariance.diagonal() << distance, distance, distance, angle, angle, angle;
    std::vector<PlaneObservation>& observations = observations_[line - which_.first];
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const PosedRibbon ribbon(lines_.ribbon(lines_.first_ribbon(line) + i), result.T_model_base);
      observations[i].candidates = known_.landmarks().landmarks_near(ribbon);
    }
    result.matches = known_.landmarks().matches(observations, belief);
    return result;
  }

  /// Gathers ribbons without a match to new planes, which become landmarks.
  void add_new_planes(const AssociationGates& gates, std::vector<ObservingLine>& observing) {
    PlaneMap map(settings_.shared.bridged_gap_m, gates);
    for (const LooseRibbon& loose : loose_) {
      map.add({lines_.ribbon(loose.ribbon), known_lines_[loose.line].T_model_base}, loose.ribbon);
    }
    for (std::uint32_t line = which_.first; line < which_.end; ++line) {
      const ObservingLine& known = observing[line - which_.first];
      const std::vector<PlaneObservation>& observations = observations_[line - which_.first];
      auto match = known.matches.begin();
      for (std::size_t i = 0; i < observations.size(); ++i) {
        if (match != known.matches.end() && match->observation == &observations[i]) {
          ++match;
          continue;
        }
        const auto index = static_cast<std::uint32_t>(lines_.first_ribbon(line) + i);
        map.add({lines_.ribbon(index), known.T_model_base}, index);
      }
    }
    for (const Hypothesis& plane : map.merged_hypotheses()) {
      if (plane.members().size() < static_cast<std::size_t>(settings_.registration.min_ribbons)) continue;
      const auto landmark = static_cast<std::uint32_t>(landmarks_.size());
      landmarks_.push_back(landmark_of(plane));
      for (const Member& member : plane.members()) {
        const std::uint32_t line = lines_.ribbon(member.ribbon).pose;
        if (line < which_.first) {
          const auto loose = std::lower_bound(
              loose_.begin(), loose_.end(), member.ribbon,
              [](const LooseRibbon& a, std::uint32_t b) { return a.ribbon < b; });
          loose_lines_.push_back({known_lines_[loose->line].T_model_base, {{loose->observation, landmark}}});
          continue;
        }
        const PlaneObservation& observation =
            observations_[line - which_.first][member.ribbon - lines_.first_ribbon(line)];
        observing[line - which_.first].matches.push_back({&observation, landmark});
      }
    }
  }

  /// A ribbon of the context that belongs to no known plane.
  struct LooseRibbon {
    std::uint32_t ribbon;
    std::size_t line;
    const PlaneObservation* observation;
  };

  PosedLines& lines_;
  const AdjustedLines& which_;
  const OdometryNoise& noise_;
  const EstimateSettings& settings_;
  RangeNoise ranges_;
  KnownPlanes known_;
  std::vector<std::vector<PlaneObservation>> known_observations_;  // by line of the context
  std::vector<ObservingLine> known_lines_;
  std::vector<ObservingLine> loose_lines_;
  std::vector<LooseRibbon> loose_;  // ascending
  std::vector<std::vector<PlaneObservation>> observations_;  // by adjusted line
  std::vector<PlaneLandmark> landmarks_;                     // of the round
};

}  // namespace

void adjust_lines(PosedLines& lines, const AdjustedLines& which,
                  const std::vector<AssociationGates>& gates, const OdometryNoise& noise,
                  const EstimateSettings& settings) {
  if (which.first >= which.end) return;
  Adjustment adjustment(lines, which, noise, settings);
  for (const AssociationGates& round : gates) adjustment.run_round(round);
}

}  // namespace ribbon_mapper::slam
