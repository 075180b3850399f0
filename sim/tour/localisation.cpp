// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/localisation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ribbon_mapper::sim {
namespace {

/// Standard deviations of the independent errors of a planar pose.
struct PlanarSigma {
  double x_m, y_m, yaw_rad;
};

struct PlanarError {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
  Pose pose() const { return planar_pose(x_m, y_m, yaw_rad); }
};

PlanarError drawn(const PlanarSigma& sigma, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), yaw = normal(random);
  return {sigma.x_m * x, sigma.y_m * y, sigma.yaw_rad * yaw};
}

/// Returns the sigma of the odometry over `step`. gmapping (motionmodel.cpp) draws once per update,
/// with a sigma proportional to the step. Here the variance of that reference step is spread evenly
/// over the way: sigma(step) = sigma(reference) * sqrt(step / reference). So the drift does not
/// depend on how finely the way is divided.
PlanarSigma motion_sigma(const LocalisationConfig& config, const Pose& step) {
  const double way_m = step.translation().norm(), turn_rad = std::abs(yaw_of(step));
  const double drives = way_m / config.linear_update_m,
               turns = turn_rad / config.angular_update_rad;
  const auto sigma = [&](double per_drive, double per_turn) {
    return config.drift * std::hypot(per_drive * config.linear_update_m * std::sqrt(drives),
                                     per_turn * config.angular_update_rad * std::sqrt(turns));
  };
  return {sigma(config.srr, config.str), sigma(0.3 * config.srr, config.str),
          sigma(config.srt, config.stt)};
}

std::size_t sample_count(Time duration, double rate_hz) {
  return static_cast<std::size_t>(std::ceil(to_seconds(duration) * rate_hz)) + 2;
}

Time sample_time(std::size_t index, double rate_hz) {
  return from_seconds(static_cast<double>(index) / rate_hz);
}

Pose interpolated(const std::vector<Pose>& samples, double rate_hz, Time time) {
  const double at = std::clamp(to_seconds(time) * rate_hz, 0.0, samples.size() - 1.0);
  const std::size_t before = std::min(static_cast<std::size_t>(at), samples.size() - 2);
  return interpolate(samples[before], samples[before + 1], at - static_cast<double>(before));
}

}  // namespace

void LocalisationConfig::validate() const {
  const auto require = [](bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(std::string("localisation: ") + message);
  };
  require(drift >= 0.0 && drift <= 100.0, "drift must be in 0..100");
  for (const double sigma : {srr, srt, str, stt, jitter_m, jitter_rad, wander_m, wander_rad})
    require(sigma >= 0.0 && std::isfinite(sigma), "sigmas must be 0 or more");
  require(linear_update_m > 0.0, "linear_update must be above 0 m");
  require(angular_update_rad > 0.0, "angular_update must be above 0 rad");
  require(odometry_rate_hz > 0.0 && odometry_rate_hz <= 1000.0, "odometry_rate: up to 1000 Hz");
  require(map_rate_hz > 0.0 && map_rate_hz <= 1000.0, "map_rate: up to 1000 Hz");
  faults.validate();
}

Localisation::Localisation(const Route& route, const LocalisationConfig& config, std::uint64_t seed)
    : route_(route), config_(config) {
  config_.validate();
  std::mt19937_64 random(seed);
  drive_odometry(random);
  match_scans(random);
}

void Localisation::drive_odometry(std::mt19937_64& random) {
  Pose T_map_base = route_.T_map_base(Time(0));
  Pose T_odom_base = Pose::Identity();
  double begin_s = 0.0;
  T_odom_map_ = {T_map_base.inverse()};
  const std::size_t count = sample_count(route_.duration(), config_.odometry_rate_hz);
  while (T_odom_map_.size() < count) {
    const Time end = sample_time(T_odom_map_.size(), config_.odometry_rate_hz);
    const Pose next = route_.T_map_base(end);
    const Pose step =
        config_.faults.reported(T_map_base.inverse() * next, begin_s, to_seconds(end));
    T_odom_base = T_odom_base * step * drawn(motion_sigma(config_, step), random).pose();
    T_odom_base.translation().z() = 0.0;
    T_map_base = next;
    begin_s = to_seconds(end);
    T_odom_map_.push_back(T_odom_base * T_map_base.inverse());
  }
}

void Localisation::match_scans(std::mt19937_64& random) {
  const double d = config_.drift;
  const PlanarSigma jitter{d * config_.jitter_m, d * config_.jitter_m, d * config_.jitter_rad};
  const PlanarSigma wander{d * config_.wander_m, d * config_.wander_m, d * config_.wander_rad};
  // Ornstein-Uhlenbeck: the place within the cell is forgotten by the next update.
  const double correlation_s = config_.linear_update_m / route_.speed_m_s();
  const double keep = std::exp(-1.0 / (config_.map_rate_hz * correlation_s));
  const double fresh = std::sqrt(1.0 - keep * keep);
  const Pose T_map_start = route_.T_map_base(Time(0));
  PlanarError error = drawn(wander, random);
  const std::size_t count = sample_count(route_.duration(), config_.map_rate_hz);
  while (T_map_odom_.size() < count) {
    const Pose T_odom_base =
        this->T_odom_base(sample_time(T_map_odom_.size(), config_.map_rate_hz));
    const Pose T_base_matched = error.pose() * drawn(jitter, random).pose();
    T_map_odom_.push_back(T_map_start * T_odom_base * T_base_matched * T_odom_base.inverse());
    const PlanarError news = drawn(wander, random);
    error = {keep * error.x_m + fresh * news.x_m, keep * error.y_m + fresh * news.y_m,
             keep * error.yaw_rad + fresh * news.yaw_rad};
  }
}

Pose Localisation::T_odom_base(Time time) const {
  return interpolated(T_odom_map_, config_.odometry_rate_hz, time) * route_.T_map_base(time);
}

Pose Localisation::T_map_odom(Time time) const {
  return interpolated(T_map_odom_, config_.map_rate_hz, time);
}

}  // namespace ribbon_mapper::sim
