// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/robot/tilt_profile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/robot/pr2.hpp"

namespace ribbon_mapper::sim {
namespace {

using Shape = TiltProfileConfig::Shape;

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument("tilt profile: " + message);
}

/// Returns the cruise speed [rad/s] of a motion from rest to rest over `way_rad` in `duration_s`.
double cruise_rad_s(double way_rad, double duration_s, double acceleration_rad_s2) {
  const double reach = acceleration_rad_s2 * duration_s;
  return (reach - std::sqrt(reach * reach - 4.0 * acceleration_rad_s2 * way_rad)) / 2.0;
}

/// Returns the way after `time_s` of such a motion [rad].
double blended_way(double way_rad, double duration_s, double acceleration_rad_s2, double time_s) {
  const double speed = cruise_rad_s(way_rad, duration_s, acceleration_rad_s2);
  const double ramp_s = speed / acceleration_rad_s2;
  const double left_s = duration_s - time_s;
  if (time_s < ramp_s) return acceleration_rad_s2 * time_s * time_s / 2.0;
  if (left_s < ramp_s) return way_rad - acceleration_rad_s2 * left_s * left_s / 2.0;
  return speed * (time_s - ramp_s / 2.0);
}

void validate_segment(const TiltProfileConfig& config, std::size_t i) {
  const double way_rad = std::abs(config.positions_rad[i] - config.positions_rad[i - 1]);
  const double duration_s = config.times_s[i] - config.times_s[i - 1];
  require(duration_s > 0.0, "times must increase");
  const double a = config.max_acceleration_rad_s2;
  const bool blended = config.shape == Shape::blended_linear;
  require(!blended || 4.0 * way_rad <= a * duration_s * duration_s,
          "the acceleration limit leaves too little time for " + std::to_string(way_rad) + " rad");
  const double speed = blended ? cruise_rad_s(way_rad, duration_s, a) : way_rad / duration_s;
  require(speed <= pr2::kTiltSpeed_rad_s, "faster than the joint's 10 rad/s; give it more time");
}

}  // namespace

TiltProfileConfig TiltProfileConfig::linear(double period_s, double amplitude_rad,
                                            double offset_rad) {
  const double up = offset_rad - amplitude_rad, down = offset_rad + amplitude_rad;
  return {Shape::linear, {up, down, up}, {0.0, period_s / 2.0, period_s}, 30.0};
}

TiltProfileConfig TiltProfileConfig::preset(const std::string& name) {
  if (name == "manip") return linear(3.0, 0.75, 0.25);
  if (name == "slow") return linear(10.0, 0.75, 0.25);
  if (name == "nav") return {Shape::blended_linear, {1.05, -0.7, 1.05}, {0.0, 1.8, 2.3125}, 30.0};
  throw std::invalid_argument("tilt profile '" + name + "' is unknown; use manip, nav or slow");
}

void TiltProfileConfig::validate() const {
  require(positions_rad.size() >= 2 && positions_rad.size() == times_s.size(),
          "positions and times must be equally many, two or more");
  const auto finite = [](double value) { return std::isfinite(value); };
  require(std::all_of(positions_rad.begin(), positions_rad.end(), finite) &&
              std::all_of(times_s.begin(), times_s.end(), finite),
          "positions and times must be finite");
  require(times_s.front() == 0.0, "times must begin with 0");
  require(positions_rad.front() == positions_rad.back(), "the last position must equal the first");
  require(max_acceleration_rad_s2 > 0.0, "max_acceleration must be above 0 rad/s2");
  for (std::size_t i = 1; i < times_s.size(); ++i) validate_segment(*this, i);
}

TiltProfile::TiltProfile(const TiltProfileConfig& config) : config_(config) {
  config_.validate();
  for (double& position : config_.positions_rad)
    position = std::clamp(position, pr2::kTiltLower_rad, pr2::kTiltUpper_rad);
}

double TiltProfile::angle_rad(Time time) const {
  const double time_in_all_s = to_seconds(time);
  const double phase_s = time_in_all_s - period_s() * std::floor(time_in_all_s / period_s());
  std::size_t i = 1;
  while (i + 1 < config_.times_s.size() && phase_s >= config_.times_s[i]) ++i;
  const double from_rad = config_.positions_rad[i - 1], to_rad = config_.positions_rad[i];
  const double duration_s = config_.times_s[i] - config_.times_s[i - 1];
  const double time_s = phase_s - config_.times_s[i - 1];
  if (config_.shape == Shape::linear) return from_rad + (to_rad - from_rad) * time_s / duration_s;
  const double way_rad =
      blended_way(std::abs(to_rad - from_rad), duration_s, config_.max_acceleration_rad_s2, time_s);
  return from_rad + std::copysign(way_rad, to_rad - from_rad);
}

}  // namespace ribbon_mapper::sim
