// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/robot/hokuyo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sim/robot/stream_seed.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr float kNoReturn = std::numeric_limits<float>::infinity();
constexpr double kTurn_s = 60.0 / 2400.0;  // 2400 rpm (hokuyo_node)

/// Range difference between neighbouring beams that makes a depth edge.
constexpr double kDepthEdge_m = 0.05;

Eigen::Vector2d in_scan_plane(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Ray ray_of(const Pose& T_map_laser, const Eigen::Vector2d& direction) {
  return {T_map_laser.translation(), direction.x() * T_map_laser.linear().col(0) +
                                         direction.y() * T_map_laser.linear().col(1)};
}

std::uint64_t line_seed(std::uint64_t seed, Time stamp) {
  return stream_seed(seed, stream_seed(0, static_cast<std::uint64_t>(stamp.count())));
}

bool is_edge(double own_m, double other_m) {
  return std::isfinite(own_m) && std::isfinite(other_m) && std::abs(other_m - own_m) > kDepthEdge_m;
}

}  // namespace

RangeNoise range_noise_from(const std::string& name) {
  if (name == "none") return RangeNoise::none;
  if (name == "gazebo") return RangeNoise::gazebo;
  if (name == "datasheet") return RangeNoise::datasheet;
  if (name == "pomerleau") return RangeNoise::pomerleau;
  throw std::invalid_argument("range noise '" + name +
                              "' is unknown; use none, gazebo, datasheet or pomerleau");
}

double sigma_m(RangeNoise noise, double range_m) {
  switch (noise) {
    case RangeNoise::none:
      return 0.0;
    case RangeNoise::gazebo:
      return 0.005;
    case RangeNoise::datasheet:
      return range_m <= 10.0 ? 0.01 : 0.03;
    case RangeNoise::pomerleau:
      return std::max(0.018, 0.0006 * range_m + 0.0015);
  }
  return 0.0;
}

HokuyoConfig HokuyoConfig::base_laser() {
  HokuyoConfig config;
  config.angle_min_rad = -2.2689;
  config.angle_max_rad = 2.2689;
  return config;
}

void HokuyoConfig::set_beams(int count) {
  constexpr double kWithinStep = 1e-3;  // so that rounding removes no beam
  const int beams_before_middle = count / 2, beams_after_middle = count - 1 - count / 2;
  angle_min_rad = (kWithinStep - beams_before_middle) * angle_increment_rad;
  angle_max_rad = (beams_after_middle + kWithinStep) * angle_increment_rad;
}

void HokuyoConfig::validate() const {
  const auto require = [](bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(std::string("hokuyo: ") + message);
  };
  require(rate_hz > 0.0 && rate_hz <= 1.0 / kTurn_s, "rate must be in 0..40 Hz");
  require(angle_min_rad >= -2.3562 && angle_min_rad < angle_max_rad && angle_max_rad <= 2.3562,
          "angles must increase within -2.3562..2.3562 rad");
  require(angle_increment_rad >= 1e-4 && angle_increment_rad <= 0.1,
          "angle_increment must be in 0.0001..0.1 rad");
  require(range_min_m >= 0.0 && range_min_m < range_max_m && range_max_m <= 60.0,
          "ranges must increase within 0..60 m");
  require(noise_scale >= 0.0 && noise_scale <= 100.0, "noise_scale must be in 0..100");
  require(quantisation_m >= 0.0 && quantisation_m <= 0.1, "quantisation must be in 0..0.1 m");
}

Hokuyo::Hokuyo(const HokuyoConfig& config, std::uint64_t seed) : config_(config), seed_(seed) {
  config_.validate();
  // hokuyo_node counts steps from the rear, 540 being straight ahead, and truncates fractions.
  const double per_rad = 1.0 / config_.angle_increment_rad;
  const double ahead = std::floor(0.75 * kPi * per_rad);
  first_step_ = static_cast<int>(std::floor(ahead + config_.angle_min_rad * per_rad) - ahead);
  last_step_ = static_cast<int>(std::floor(ahead + config_.angle_max_rad * per_rad) - ahead);
  for (int step = first_step_; step <= last_step_; ++step)
    directions_.push_back(in_scan_plane(step * config_.angle_increment_rad));
  for (int i = 0; i < beam_count(); ++i)
    times_.push_back(from_seconds(i * kTurn_s * config_.angle_increment_rad / (2.0 * kPi)));
}

Time Hokuyo::period() const { return from_seconds(1.0 / config_.rate_hz); }

Time Hokuyo::sweep_time() const { return times_.back(); }

Scan Hokuyo::scan(const World& world, Time stamp, const LaserPose& T_map_laser) const {
  Scan scan;
  scan.stamp = stamp;
  scan.angle_min_rad = angle_min_rad();
  scan.angle_increment_rad = config_.angle_increment_rad;
  scan.time_increment_s = kTurn_s * config_.angle_increment_rad / (2.0 * kPi);
  scan.scan_time_s = 1.0 / config_.rate_hz;
  scan.range_min_m = config_.range_min_m;
  scan.range_max_m = config_.range_max_m;
  scan.rays.reserve(directions_.size());
  for (int i = 0; i < beam_count(); ++i) {
    scan.rays.push_back(ray_of(T_map_laser(stamp + times_[i]), directions_[i]));
  }
  for (const Ray& ray : scan.rays) {
    const auto hit = world.cast(ray.origin, ray.direction, config_.range_max_m);
    scan.true_ranges_m.push_back(hit ? static_cast<float>(hit->range_m) : kNoReturn);
    scan.faces.push_back(hit ? hit->face : -1);
  }
  std::mt19937_64 random(line_seed(seed_, stamp));
  std::normal_distribution<double> normal;
  for (const double range_m : mixed_ranges_m(world, scan, T_map_laser, random))
    scan.ranges_m.push_back(measured_m(range_m, normal(random)));
  return scan;
}

/// A beam whose spot lies on two surfaces measures a range between theirs, weighted by their
/// shares. The spot is assumed to be one angular step wide; the datasheet's figures are larger.
/// Only beams beside a depth edge of their line are examined, by a ray along the rim of their spot.
std::vector<double> Hokuyo::mixed_ranges_m(const World& world, const Scan& scan,
                                           const LaserPose& T_map_laser,
                                           std::mt19937_64& random) const {
  const std::vector<float>& true_m = scan.true_ranges_m;
  std::vector<double> mixed_m(true_m.begin(), true_m.end());
  if (!config_.mixed_pixels) return mixed_m;
  std::uniform_real_distribution<double> share(0.0, 0.5);
  for (int i = 0; i < beam_count(); ++i)
    for (const int side : {-1, 1}) {
      const int beside = i + side;
      if (beside < 0 || beside >= beam_count() || !is_edge(true_m[i], true_m[beside])) continue;
      const double angle_rad = (first_step_ + i + side / 2.0) * config_.angle_increment_rad;
      const Ray rim = ray_of(T_map_laser(scan.stamp + times_[i]), in_scan_plane(angle_rad));
      const auto hit = world.cast(rim.origin, rim.direction, config_.range_max_m);
      const double own_m = true_m[i];
      const bool is_pure = mixed_m[i] == own_m;  // not mixed at its other rim yet
      if (is_pure && hit && is_edge(own_m, hit->range_m))
        mixed_m[i] += share(random) * (hit->range_m - own_m);
    }
  return mixed_m;
}

float Hokuyo::measured_m(double range_m, double normal) const {
  if (!std::isfinite(range_m)) return kNoReturn;
  double value_m = range_m + config_.noise_scale * sigma_m(config_.noise, range_m) * normal;
  if (config_.quantisation_m > 0.0)
    value_m = std::round(value_m / config_.quantisation_m) * config_.quantisation_m;
  if (value_m < config_.range_min_m) return -kNoReturn;
  return value_m > config_.range_max_m ? kNoReturn : static_cast<float>(value_m);
}

}  // namespace ribbon_mapper::sim
