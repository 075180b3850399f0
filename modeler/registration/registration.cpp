// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/registration.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/observations/posed_observations.hpp"
#include "modeler/registration/line_state.hpp"
#include "modeler/registration/odometry_noise.hpp"
#include "modeler/registration/plane_adjustment.hpp"
#include "modeler/registration/plane_landmarks.hpp"
#include "modeler/registration/segment_smoother.hpp"
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {
namespace {

// The three lines that a ribbon is made from: between so few there is nothing to register.
constexpr std::uint32_t kLinesOfRibbon = 3;

class Registration {
 public:
  Registration(const std::vector<Ribbon>& ribbons, const Trajectory& trajectory,
               std::vector<TrajectorySegment> segments, const RegistrationConfig& config,
               const SharedSettings& shared);

  bool is_needed() const { return !segments_.empty(); }
  void run_round();
  std::vector<StampedPose> poses() const;

 private:
  void add_observations(const PackedPoses& T_odom_base);
  void select_segments(std::vector<TrajectorySegment> segments);
  bool needs_registration(const TrajectorySegment& segment, const SegmentSmoother& odometry) const;
  void localise(const TrajectorySegment& segment, const SegmentSmoother& odometry);
  void find_candidates(const PosedObservations& observations, PlaneLandmarks& landmarks);
  ObservingSegment smoothed(const TrajectorySegment& segment, const PlaneLandmarks& landmarks);
  std::vector<ObservingLine> known_lines(const PlaneLandmarks& landmarks) const;
  void take_poses_from(const ObservingSegment& observing);
  double gate_m(double ratio) const { return ratio * shared_.gates.distance_m; }
  double sigma_m(const LineState& line, const PoseBelief& belief) const;

  const std::vector<Ribbon>& ribbons_;
  const RegistrationConfig config_;
  const SharedSettings shared_;
  const RangeNoise range_noise_;
  const OdometryNoise odometry_noise_;
  std::vector<LineState> lines_;
  std::vector<TrajectorySegment> segments_;  // to be registered, in map
  Pose T_map_model_ = Pose::Identity();      // of the round
};

/// The number of lines of the longest segment between two corrected poses.
std::uint32_t max_closed_lines(const std::vector<TrajectorySegment>& segments) {
  std::uint32_t lines = 0;
  for (const TrajectorySegment& segment : segments) {
    if (!segment.is_open()) lines = std::max(lines, segment.lines());
  }
  return lines;
}

Registration::Registration(const std::vector<Ribbon>& ribbons, const Trajectory& trajectory,
                           std::vector<TrajectorySegment> segments,
                           const RegistrationConfig& config, const SharedSettings& shared)
    : ribbons_(ribbons),
      config_(config),
      shared_(shared),
      range_noise_{shared.range_sigma_m, config.shared_sigma_ratio},
      odometry_noise_(fitted_noise(segments)) {
  for (const StampedPose& pose : trajectory.poses()) lines_.push_back({pose, {}, true, false, {}});
  T_map_model_ = lines_.front().pose.T_map_base;
  add_observations(trajectory.recorded().T_odom_base());
  select_segments(std::move(segments));
}

void Registration::add_observations(const PackedPoses& T_odom_base) {
  for (const Ribbon& ribbon : ribbons_) {
    const std::size_t next = std::min<std::size_t>(ribbon.pose + 1, lines_.size() - 1);
    const Pose step = T_odom_base[next - 1].inverse(Eigen::Isometry) * T_odom_base[next];
    lines_[ribbon.pose].observations.emplace_back(ribbon, range_noise_,
                                                  odometry_noise_.variances(step));
  }
}

void Registration::select_segments(std::vector<TrajectorySegment> segments) {
  const std::uint32_t max_lines = max_closed_lines(segments);
  for (TrajectorySegment& segment : segments) {
    set_step_variances(odometry_noise_, segment);
    for (std::uint32_t i = segment.first_line; i < segment.end_line; ++i) {
      lines_[i].is_localised = !segment.is_open();
    }
    if (segment.lines() <= kLinesOfRibbon || segment.lines() > max_lines) continue;
    const SegmentSmoother odometry(in_frame(segment, T_map_model_));
    if (!needs_registration(segment, odometry)) continue;
    localise(segment, odometry);
    segments_.push_back(std::move(segment));
  }
}

/// The standard deviation of the distances of a line's ribbons from their planes, as far as it
/// comes from the line's pose.
double Registration::sigma_m(const LineState& line, const PoseBelief& belief) const {
  if (line.observations.empty()) return 0.0;
  double square_sum = 0.0;
  for (const PlaneObservation& observation : line.observations) {
    const Pose& T = belief.T_model_base;
    const Vector6 derivative =
        derivative_by_pose(observation, T.linear() * observation.normal, T).row(0).transpose();
    square_sum += derivative.dot(belief.covariance * derivative);
  }
  return std::sqrt(std::max(0.0, square_sum) / static_cast<double>(line.observations.size()));
}

bool Registration::needs_registration(const TrajectorySegment& segment,
                                      const SegmentSmoother& odometry) const {
  for (std::uint32_t i = 0; i < segment.lines(); ++i) {
    const double sigma = sigma_m(lines_[segment.first_line + i], odometry.without(i));
    if (sigma > range_noise_.shared_sigma_m()) return true;
  }
  return false;
}

void Registration::localise(const TrajectorySegment& segment, const SegmentSmoother& odometry) {
  for (std::uint32_t i = 0; i < segment.lines(); ++i) {
    LineState& line = lines_[segment.first_line + i];
    const PoseBelief belief = odometry.without(i);
    line.pose.T_map_base = T_map_model_ * belief.T_model_base;
    line.is_registered = true;
    line.is_localised = sigma_m(line, belief) <= gate_m(config_.start_gate_ratio);
    if (!line.is_localised) line.localised_by = static_cast<std::uint32_t>(segments_.size());
  }
}

void Registration::find_candidates(const PosedObservations& observations,
                                   PlaneLandmarks& landmarks) {
  std::size_t ribbon = 0;
  for (LineState& line : lines_) {
    for (PlaneObservation& observation : line.observations) {
      observation.candidates = landmarks.landmarks_near(observations.ribbon(ribbon++));
    }
  }
}

ObservingSegment Registration::smoothed(const TrajectorySegment& segment,
                                        const PlaneLandmarks& landmarks) {
  ObservingSegment result{in_frame(segment, T_map_model_), {}};
  SegmentSmoother smoother(result.segment);
  const auto measure = [&](std::size_t line, const PoseBelief& without_it) {
    return landmarks.measure(lines_[segment.first_line + line].observations, without_it);
  };
  for (int i = 0; i < config_.passes_per_round; ++i) smoother.smooth(measure);
  for (std::uint32_t i = 0; i < segment.lines(); ++i) {
    LineState& line = lines_[segment.first_line + i];
    const PoseBelief without = smoother.without(i);
    const PoseBelief belief = updated(without, measure(i, without));
    line.is_localised = sigma_m(line, belief) <= gate_m(config_.final_gate_ratio);
    result.lines.push_back({belief.T_model_base, landmarks.matches(line.observations, belief)});
  }
  return result;
}

std::vector<ObservingLine> Registration::known_lines(const PlaneLandmarks& landmarks) const {
  const Pose T_model_map = T_map_model_.inverse(Eigen::Isometry);
  std::vector<ObservingLine> known;
  for (const LineState& line : lines_) {
    if (line.is_registered || !line.is_localised) continue;
    const PoseBelief exact{T_model_map * line.pose.T_map_base, Matrix6::Zero()};
    known.push_back({exact.T_model_base, landmarks.matches(line.observations, exact)});
  }
  return known;
}

void Registration::take_poses_from(const ObservingSegment& observing) {
  for (std::uint32_t i = 0; i < observing.segment.lines(); ++i) {
    lines_[observing.segment.first_line + i].pose.T_map_base =
        T_map_model_ * observing.lines[i].T_model_base;
  }
}

void Registration::run_round() {
  const std::vector<UnassignedPoints> no_unassigned;
  const PosedObservations observations(ribbons_, no_unassigned, poses());
  T_map_model_ = observations.T_map_model();
  PlaneLandmarks landmarks(
      supported_planes(observations, lines_, config_, shared_),
      [&](std::uint32_t ribbon) { return observations.ribbon(ribbon); }, shared_.bridged_gap_m,
      config_);
  find_candidates(observations, landmarks);
  std::vector<ObservingSegment> segments;
  for (const TrajectorySegment& segment : segments_) {
    segments.push_back(smoothed(segment, landmarks));
  }
  const std::vector<ObservingLine> known = known_lines(landmarks);
  std::vector<PlaneLandmark> planes = landmarks.all();
  for (int i = 0; i < config_.adjustments_per_round; ++i) {
    adjust(known, segments, planes, config_.robust_sigmas);
  }
  for (const ObservingSegment& segment : segments) take_poses_from(segment);
}

std::vector<StampedPose> Registration::poses() const {
  std::vector<StampedPose> poses;
  poses.reserve(lines_.size());
  for (const LineState& line : lines_) poses.push_back(line.pose);
  return poses;
}

}  // namespace

std::vector<StampedPose> registered_poses(const std::vector<Ribbon>& ribbons,
                                          const Trajectory& trajectory,
                                          const RegistrationConfig& config,
                                          const SharedSettings& shared) {
  if (!config.enabled || !trajectory.is_corrected()) return {};
  std::vector<TrajectorySegment> segments =
      segments_between(trajectory.recorded(), trajectory.corrected());
  if (max_closed_lines(segments) <= kLinesOfRibbon) return {};
  Registration registration(ribbons, trajectory, std::move(segments), config, shared);
  if (!registration.is_needed()) return {};
  for (int round = 0; round < config.rounds; ++round) registration.run_round();
  return registration.poses();
}

}  // namespace ribbon_mapper
