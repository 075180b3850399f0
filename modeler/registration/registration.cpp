// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/registration.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/registration/odometry_noise.hpp"
#include "modeler/registration/plane_adjustment.hpp"
#include "modeler/registration/plane_landmarks.hpp"
#include "modeler/registration/segment_smoother.hpp"
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper {
namespace {

constexpr int rounds = 3;           // of planes and poses in turn
constexpr int sweeps_of_round = 2;  // of a bridge
constexpr int adjustments_of_round = 2;
constexpr std::uint32_t lines_of_ribbon = 3;
// A line is placed right if its ribbons are so within this part of the gate: at first its sigma
// (the gate is two of these), then half of it.
constexpr double placed_at_first = 0.5, placed_in_the_end = 0.25;

class Registration {
 public:
  Registration(const std::vector<Ribbon>& ribbons, const Trajectory& trajectory,
               std::vector<Span> spans, const ModelerConfig& config, double range_sigma_m);

  bool is_needed() const { return !spans_.empty(); }
  void evaluate_planes_and_poses();
  const std::vector<StampedPose>& poses() const { return poses_; }

 private:
  void take_spans(std::vector<Span> spans);
  void view_ribbons(const PackedPoses& T_odom_base);
  Bridge bridge_over(const Span& span) const;
  bool is_to_be_registered(const Span& span) const;
  void start(const Span& span);
  LineChain register_span(const Span& span, const ReferencePlanes& planes);
  std::vector<FixedLine> fixed_lines(const ReferencePlanes& planes) const;
  void find_planes_near(const PosedObservations& observations, ReferencePlanes& planes);
  void take_over(const LineChain& chain, const Span& span);
  void place(std::uint32_t line, const PoseBelief& belief, double part_of_gate);
  double sigma_m(std::uint32_t line, const PoseBelief& belief) const;

  const std::vector<Ribbon>& ribbons_;
  const ModelerConfig& config_;
  double range_sigma_m_;
  OdometryNoise noise_;
  std::vector<Span> spans_;                 // to be registered
  std::vector<std::vector<Sight>> sights_;  // by line
  std::vector<StampedPose> poses_;          // by line
  std::vector<StampedPose> next_poses_;     // of the round to come
  std::vector<char> is_placed_;             // by line: right
  std::vector<std::int32_t> witness_;       // by line, see ReferencePlanes
  std::vector<char> is_fixed_;              // by line: not in spans_
  Pose T_map_model_ = Pose::Identity();     // of the round
};

/// Of all spans whose both ends are known.
std::vector<OdometryCheck> odometry_checks(const std::vector<Span>& spans) {
  std::vector<OdometryCheck> checks;
  for (const Span& span : spans) {
    if (span.has_loose_end()) continue;
    checks.push_back(
        {odometry_steps(span), span.T_map_first->inverse(Eigen::Isometry) * *span.T_map_last});
  }
  return checks;
}

std::uint32_t max_lines_of_bridge(const std::vector<Span>& spans) {
  std::uint32_t most = 0;
  for (const Span& span : spans) {
    if (!span.has_loose_end()) most = std::max(most, span.lines());
  }
  return most;
}

std::optional<Pose> in_world(const Pose& T_map_model, const std::optional<Pose>& T_map_base) {
  if (!T_map_base) return std::nullopt;
  return T_map_model.inverse(Eigen::Isometry) * *T_map_base;
}

Registration::Registration(const std::vector<Ribbon>& ribbons, const Trajectory& trajectory,
                           std::vector<Span> spans, const ModelerConfig& config,
                           double range_sigma_m)
    : ribbons_(ribbons),
      config_(config),
      range_sigma_m_(range_sigma_m),
      noise_(fitted_to(odometry_checks(spans))),
      poses_(trajectory.poses()),
      next_poses_(poses_),
      is_placed_(poses_.size(), 1),
      witness_(poses_.size(), ReferencePlanes::kSure),
      is_fixed_(poses_.size(), 1),
      T_map_model_(poses_.front().T_map_base) {
  view_ribbons(trajectory.recorded().T_odom_base());
  take_spans(std::move(spans));
}

void Registration::take_spans(std::vector<Span> spans) {
  const std::uint32_t max_lines = max_lines_of_bridge(spans);
  for (Span& span : spans) {
    if (span.has_loose_end()) {
      std::fill(is_placed_.begin() + span.first_line, is_placed_.begin() + span.end_line, 0);
    }
    if (span.lines() <= lines_of_ribbon || span.lines() > max_lines) continue;
    if (!is_to_be_registered(span)) continue;
    start(span);
    spans_.push_back(std::move(span));
  }
}

void Registration::view_ribbons(const PackedPoses& T_odom_base) {
  sights_.resize(poses_.size());
  for (const Ribbon& ribbon : ribbons_) {
    const std::size_t next = std::min<std::size_t>(ribbon.pose + 1, poses_.size() - 1);
    const Pose step = T_odom_base[next - 1].inverse(Eigen::Isometry) * T_odom_base[next];
    // On average a beam is a quarter of the time between lines from the middle of its line.
    const Vector6 motion = 0.25 * noise_.variances(step);
    sights_[ribbon.pose].emplace_back(ribbon, range_sigma_m_, motion);
  }
}

Bridge Registration::bridge_over(const Span& span) const {
  return {odometry_steps(span), noise_, in_world(T_map_model_, span.T_map_first),
          in_world(T_map_model_, span.T_map_last)};
}

double Registration::sigma_m(std::uint32_t line, const PoseBelief& belief) const {
  if (sights_[line].empty()) return 0.0;
  double square_sum = 0.0;
  for (const Sight& sight : sights_[line]) {
    const Pose& T = belief.T_model_base;
    const Vector6 derivative = by_pose(sight, T.linear() * sight.normal, T).row(0).transpose();
    square_sum += derivative.dot(belief.covariance * derivative);
  }
  return std::sqrt(std::max(0.0, square_sum) / static_cast<double>(sights_[line].size()));
}

void Registration::place(std::uint32_t line, const PoseBelief& belief, double part_of_gate) {
  next_poses_[line].T_map_base = T_map_model_ * belief.T_model_base;
  is_placed_[line] =
      sigma_m(line, belief) <= part_of_gate * config_.association.corrected.distance_m;
}

bool Registration::is_to_be_registered(const Span& span) const {
  const Bridge bridge = bridge_over(span);
  for (std::uint32_t i = 0; i < span.lines(); ++i) {
    const double sigma = sigma_m(span.first_line + i, bridge.without(i));
    if (sigma > shared_part_of_sigma * range_sigma_m_) return true;
  }
  return false;
}

void Registration::start(const Span& span) {
  const Bridge bridge = bridge_over(span);
  for (std::uint32_t i = 0; i < span.lines(); ++i) {
    const std::uint32_t line = span.first_line + i;
    is_fixed_[line] = 0;
    place(line, bridge.without(i), placed_at_first);
    if (!is_placed_[line]) witness_[line] = static_cast<std::int32_t>(spans_.size());
  }
}

LineChain Registration::register_span(const Span& span, const ReferencePlanes& planes) {
  Bridge bridge = bridge_over(span);
  const auto observe = [&](std::size_t line, const PoseBelief& without_it) {
    return planes.observe(sights_[span.first_line + line], without_it);
  };
  for (int i = 0; i < sweeps_of_round; ++i) bridge.sweep(observe);
  LineChain chain{in_world(T_map_model_, span.T_map_first),
                  in_world(T_map_model_, span.T_map_last),
                  odometry_steps(span),
                  {},
                  {}};
  for (const Pose& step : chain.steps) chain.variances.push_back(noise_.variances(step));
  for (std::uint32_t i = 0; i < span.lines(); ++i) {
    const PoseBelief without = bridge.without(i), belief = updated(without, observe(i, without));
    place(span.first_line + i, belief, placed_in_the_end);
    chain.lines.push_back(
        {belief.T_model_base, planes.sightings(sights_[span.first_line + i], belief)});
  }
  return chain;
}

std::vector<FixedLine> Registration::fixed_lines(const ReferencePlanes& planes) const {
  std::vector<FixedLine> fixed;
  for (std::size_t line = 0; line < poses_.size(); ++line) {
    if (!is_fixed_[line] || !is_placed_[line]) continue;
    const PoseBelief belief{*in_world(T_map_model_, poses_[line].T_map_base), Matrix6::Zero()};
    fixed.push_back({belief.T_model_base, planes.sightings(sights_[line], belief)});
  }
  return fixed;
}

void Registration::find_planes_near(const PosedObservations& observations,
                                    ReferencePlanes& planes) {
  std::size_t ribbon = 0;
  for (std::vector<Sight>& sights : sights_) {
    for (Sight& sight : sights) planes.find_near(observations.ribbon(ribbon++), sight);
  }
}

void Registration::evaluate_planes_and_poses() {
  const std::vector<UnassignedPoints> no_unassigned;
  for (int round = 0; round < rounds; ++round) {
    poses_ = next_poses_;
    const PosedObservations observations(ribbons_, no_unassigned, poses_);
    T_map_model_ = observations.T_map_model();
    ReferencePlanes reference(observations, is_placed_, witness_, config_);
    find_planes_near(observations, reference);
    std::vector<LineChain> chains;
    for (const Span& span : spans_) chains.push_back(register_span(span, reference));
    const std::vector<FixedLine> fixed = fixed_lines(reference);
    std::vector<SightedPlane> planes = reference.planes();
    for (int i = 0; i < adjustments_of_round; ++i) adjust(fixed, chains, planes);
    for (std::size_t i = 0; i < spans_.size(); ++i) take_over(chains[i], spans_[i]);
  }
  poses_ = next_poses_;
}

void Registration::take_over(const LineChain& chain, const Span& span) {
  for (std::uint32_t i = 0; i < span.lines(); ++i) {
    next_poses_[span.first_line + i].T_map_base = T_map_model_ * chain.lines[i].T_model_base;
  }
}

}  // namespace

std::vector<StampedPose> registered_poses(const std::vector<Ribbon>& ribbons,
                                          const Trajectory& trajectory, const ModelerConfig& config,
                                          double range_sigma_m) {
  std::vector<Span> spans = spans_between(trajectory.recorded(), trajectory.corrected());
  if (max_lines_of_bridge(spans) <= lines_of_ribbon) return {};
  Registration registration(ribbons, trajectory, std::move(spans), config, range_sigma_m);
  if (!registration.is_needed()) return {};
  registration.evaluate_planes_and_poses();
  return registration.poses();
}

}  // namespace ribbon_mapper
