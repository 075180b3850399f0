// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/line_tracker.hpp"

#include <algorithm>
#include <limits>

namespace ribbon_mapper::slam {
namespace {

constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max();

}  // namespace

LineTracker::LineTracker(const EstimateSettings& settings)
    : settings_(settings),
      new_planes_(settings.shared.bridged_gap_m, settings.estimate.gates.back()) {}

void LineTracker::restart(KnownPlanes planes, const PoseBelief& belief) {
  known_ = std::move(planes);
  belief_ = belief;
  new_planes_ = PlaneMap(settings_.shared.bridged_gap_m, settings_.estimate.gates.back());
  seen_m_ = known_m_ = 0.0;
}

void LineTracker::list_candidates(const PosedLines& lines, std::uint32_t line) {
  landmarks_.clear();
  known_numbers_.clear();
  const auto min_ribbons = static_cast<std::size_t>(settings_.registration.min_ribbons);
  const auto list = [&](const PlaneLandmark& landmark, std::uint32_t number,
                        PlaneObservation& observation) {
    observation.candidates.push_back(static_cast<std::uint32_t>(landmarks_.size()));
    landmarks_.push_back(landmark);
    known_numbers_.push_back(number);
  };
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    const PosedRibbon ribbon(lines.ribbon(lines.first_ribbon(line) + i), belief_.T_model_base);
    if (known_) {
      for (const std::uint32_t number : known_->landmarks().landmarks_near(ribbon)) {
        list(known_->landmarks().all()[number], number, observations_[i]);
      }
    }
    for (const Hypothesis* plane : new_planes_.near(ribbon)) {
      if (plane->members().size() < min_ribbons) continue;
      list(landmark_of(*plane), kNew, observations_[i]);
    }
  }
}

void LineTracker::add_ribbons(const PosedLines& lines, std::uint32_t line) {
  const LandmarkMatcher matcher(landmarks_, settings_.registration);
  std::vector<std::uint32_t> known_of(observations_.size(), kNew);
  for (const LandmarkMatch& match : matcher.matches(observations_, belief_)) {
    known_of[static_cast<std::size_t>(match.observation - observations_.data())] =
        known_numbers_[match.landmark];
  }
  for (std::size_t i = 0; i < observations_.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(lines.first_ribbon(line) + i);
    const PosedRibbon ribbon(lines.ribbon(index), belief_.T_model_base);
    const double wall_m = is_of_wall(ribbon.normal) ? ribbon.ribbon->length_m : 0.0;
    seen_m_ += wall_m;
    if (known_of[i] != kNew) known_m_ += wall_m;
    if (known_of[i] == kNew)
      new_planes_.add(ribbon, index);
    else
      known_->landmarks().extend(known_of[i], ribbon);
  }
}

void LineTracker::track(PosedLines& lines, std::uint32_t line, const OdometryNoise& noise) {
  if (line > 0) belief_ = lines.after_step_to(line, belief_, noise);
  observations_ = lines.measured(line, noise, settings_.range_noise());
  list_candidates(lines, line);
  if (line > 0) {
    const LandmarkMatcher matcher(landmarks_, settings_.registration);
    belief_ = updated(belief_, matcher.measure(observations_, belief_));
  }
  lines.set_pose(line, belief_.T_model_base);
  add_ribbons(lines, line);
}

}  // namespace ribbon_mapper::slam
