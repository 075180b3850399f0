// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/hokuyo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "sim/world.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr float kNoReturn = std::numeric_limits<float>::infinity();
constexpr double kTurn_s = 60.0 / 2400.0;  // 2400 rpm (hokuyo.cpp)

/// A neighbouring beam this much nearer or farther makes a depth edge.
constexpr double kDepthEdge_m = 0.05;

/// A ray towards the last range first: the tree is walked only that far. What it finds is the
/// nearest all the same.
constexpr double kGuessMargin_m = 0.1;

std::optional<Hit> cast_near(const World& world, const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction, double guess_m, double max_range_m) {
  if (guess_m + kGuessMargin_m < max_range_m)
    if (const auto hit = world.cast(origin, direction, guess_m + kGuessMargin_m)) return hit;
  return world.cast(origin, direction, max_range_m);
}

Eigen::Vector3d in_scan_plane(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad), 0.0};
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

void HokuyoConfig::set_beams(int count) {
  constexpr double kWithinStep = 1e-3;  // so that rounding takes no beam away
  angle_min_rad = (kWithinStep - count / 2) * angle_increment_rad;
  angle_max_rad = (count - 1 - count / 2 + kWithinStep) * angle_increment_rad;
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

struct Hokuyo::Beam {
  Pose T_map_laser;
  double angle_rad;
  Eigen::Vector3d direction;  ///< in map

  Eigen::Vector3d origin() const { return T_map_laser.translation(); }
  Eigen::Vector3d direction_beside(double offset_rad) const {
    return T_map_laser.linear() * in_scan_plane(angle_rad + offset_rad);
  }
};

Hokuyo::Hokuyo(const HokuyoConfig& config, std::uint64_t seed) : config_(config), random_(seed) {
  config_.validate();
  // hokuyo.cpp counts steps from the rear, where 540 is straight ahead, and cuts fractions off.
  const double per_rad = 1.0 / config_.angle_increment_rad;
  const double ahead = std::floor(0.75 * kPi * per_rad);
  first_step_ = static_cast<int>(std::floor(ahead + config_.angle_min_rad * per_rad) - ahead);
  last_step_ = static_cast<int>(std::floor(ahead + config_.angle_max_rad * per_rad) - ahead);
  for (int step = first_step_; step <= last_step_; ++step)
    directions_.push_back(in_scan_plane(step * config_.angle_increment_rad));
}

Time Hokuyo::period() const { return from_seconds(1.0 / config_.rate_hz); }

Time Hokuyo::beam_time(int beam) const {
  return from_seconds(beam * kTurn_s * config_.angle_increment_rad / (2.0 * kPi));
}

Time Hokuyo::sweep_time() const { return beam_time(beam_count() - 1); }

Hokuyo::Beam Hokuyo::beam(Time stamp, const LaserPose& T_map_laser, int index) const {
  const Pose T_map_laser_then = T_map_laser(stamp + beam_time(index));
  return {T_map_laser_then, (first_step_ + index) * config_.angle_increment_rad,
          T_map_laser_then.linear() * directions_[index]};
}

Scan Hokuyo::scan(const World& world, Time stamp, const LaserPose& T_map_laser) {
  Scan scan;
  scan.stamp = stamp;
  scan.angle_min_rad = angle_min_rad();
  scan.angle_increment_rad = config_.angle_increment_rad;
  scan.time_increment_s = kTurn_s * config_.angle_increment_rad / (2.0 * kPi);
  scan.scan_time_s = 1.0 / config_.rate_hz;
  scan.range_min_m = config_.range_min_m;
  scan.range_max_m = config_.range_max_m;
  const auto count = static_cast<std::size_t>(beam_count());
  std::vector<Beam> beams;
  beams.reserve(count);
  scan.ranges_m.reserve(count);
  scan.true_ranges_m.reserve(count);
  scan.faces.reserve(count);
  double guess_m = config_.range_max_m;
  for (int i = 0; i < beam_count(); ++i) {
    beams.push_back(beam(stamp, T_map_laser, i));
    const auto hit = cast_near(world, beams[i].origin(), beams[i].direction, guess_m,
                               config_.range_max_m);
    scan.true_ranges_m.push_back(hit ? static_cast<float>(hit->range_m) : kNoReturn);
    scan.faces.push_back(hit ? hit->face : -1);
    if (hit) guess_m = hit->range_m;
  }
  for (int i = 0; i < beam_count(); ++i)
    scan.ranges_m.push_back(measured(mixed(world, beams[i], scan, i)));
  return scan;
}

/// A spot that lies on two surfaces gives a range between theirs, by the share of each. The spot is
/// taken to be one angular step wide, so that spots tile the view: an assumption, the data sheet's
/// figures are larger. Only beams beside a depth edge of their line are looked at.
double Hokuyo::mixed(const World& world, const Beam& beam, const Scan& scan, int index) {
  const double range_m = scan.true_ranges_m[index];
  if (!config_.mixed_pixels || !std::isfinite(range_m)) return range_m;
  const auto is_edge = [&](int other) {
    return other >= 0 && other < beam_count() && std::isfinite(scan.true_ranges_m[other]) &&
           std::abs(scan.true_ranges_m[other] - range_m) > kDepthEdge_m;
  };
  for (const int side : {-1, 1}) {
    if (!is_edge(index + side)) continue;
    const double half_step_rad = side * config_.angle_increment_rad / 2.0;
    const auto rim = world.cast(beam.origin(), beam.direction_beside(half_step_rad), config_.range_max_m);
    if (!rim || std::abs(rim->range_m - range_m) < kDepthEdge_m) continue;
    const double share = std::uniform_real_distribution<double>(0.0, 0.5)(random_);
    return range_m + share * (rim->range_m - range_m);
  }
  return range_m;
}

float Hokuyo::measured(double range_m) {
  const double normal = std::normal_distribution<double>()(random_);
  if (!std::isfinite(range_m)) return kNoReturn;
  double value_m = range_m + config_.noise_scale * sigma_m(config_.noise, range_m) * normal;
  if (config_.quantisation_m > 0.0)
    value_m = std::round(value_m / config_.quantisation_m) * config_.quantisation_m;
  if (value_m < config_.range_min_m) return -kNoReturn;
  return value_m > config_.range_max_m ? kNoReturn : static_cast<float>(value_m);
}

}  // namespace ribbon_mapper::sim
