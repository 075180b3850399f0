// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_averaging.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

/// Ranges further than this from the mean belong to another surface.
constexpr double kSameSurfaceSigmas = 6.0;

/// Largest relative difference between the steps of similar lines.
constexpr double kSimilarSteps = 0.2;

bool has_same_beams(const LaserBeams& a, const LaserBeams& b) {
  return a.ranges_m.size() == b.ranges_m.size() && a.angle_min_rad == b.angle_min_rad &&
         a.angle_increment_rad == b.angle_increment_rad;
}

/// Returns true if a line differs from another one by a few beams only, as those of lasers do that
/// take another number of beams in each turn.
bool is_similar(const LaserBeams& a, const LaserBeams& b) {
  const double step_ratio = a.angle_increment_rad / b.angle_increment_rad;
  return has_same_beams(a, b) || std::abs(step_ratio - 1.0) < kSimilarSteps;
}

/// Returns the range of a line at a bearing, or infinity where there is no return. Between beams on
/// one surface the inverse range is interpolated: exact on planes to the square of a step.
float range_at(const LaserBeams& beams, double bearing_rad, const ScanConfig& config) {
  constexpr float none = std::numeric_limits<float>::infinity();
  const double at = (bearing_rad - beams.angle_min_rad) / beams.angle_increment_rad;
  const double left = std::floor(at), share = at - left;
  if (left < 0.0 || left + 1.0 >= static_cast<double>(beams.ranges_m.size())) return none;
  const auto i = static_cast<std::size_t>(left);
  const float a = beams.ranges_m[i], b = beams.ranges_m[i + 1];
  if (!is_return(a, beams, config) || !is_return(b, beams, config)) return none;
  if (std::abs(a - b) > mixed_pixel_step_per_range(beams, config) * std::min(a, b)) return none;
  return static_cast<float>(1.0 / ((1.0 - share) / a + share / b));
}

}  // namespace

void LineAverager::add(const LaserBeams& beams, const LinePoses& poses) {
  if (sums_.lines == kMaxLines || (sums_.lines > 0 && !is_similar(beams, sums_.beams)))
    sums_.lines = 0;
  if (sums_.lines++ == 0) {
    start(beams, poses);
  } else {
    approach(beams, poses);
  }
  sums_.last_stamp = middle_of(beams);
  add_ranges(beams);
}

void LineAverager::start(const LaserBeams& beams, const LinePoses& poses) {
  sums_.beams = beams;
  sums_.poses = poses;
  sums_.sums_m.assign(beams.ranges_m.size(), 0.0F);
  sums_.agreeing.assign(beams.ranges_m.size(), 0);
  sums_.returns.assign(beams.ranges_m.size(), 0);
}

/// Moves the mean stamp and the mean poses by the new line's share.
void LineAverager::approach(const LaserBeams& beams, const LinePoses& poses) {
  const double share = 1.0 / static_cast<double>(sums_.lines);
  sums_.beams.stamp += from_seconds(share * to_seconds(beams.stamp - sums_.beams.stamp));
  for (Pose LinePoses::*pose :
       {&LinePoses::T_odom_base_first, &LinePoses::T_odom_base_last, &LinePoses::T_base_laser_first,
        &LinePoses::T_base_laser_last, &LinePoses::T_map_base}) {
    sums_.poses.*pose = interpolate(sums_.poses.*pose, poses.*pose, share);
  }
}

void LineAverager::add_ranges(const LaserBeams& beams) {
  const double limit_m = kSameSurfaceSigmas * config_.range_sigma_m;
  const bool same = has_same_beams(beams, sums_.beams);
  for (std::size_t i = 0; i < sums_.sums_m.size(); ++i) {
    const double bearing_rad =
        sums_.beams.angle_min_rad + static_cast<double>(i) * sums_.beams.angle_increment_rad;
    const float range_m = same ? beams.ranges_m[i] : range_at(beams, bearing_rad, config_);
    if (!is_return(range_m, beams, config_)) continue;
    ++sums_.returns[i];
    if (sums_.agreeing[i] > 0 && std::abs(range_m - sums_.sums_m[i] / sums_.agreeing[i]) > limit_m)
      continue;
    sums_.sums_m[i] += range_m;
    ++sums_.agreeing[i];
  }
}

const LaserBeams& LineAverager::average_beams() {
  for (std::size_t i = 0; i < sums_.sums_m.size(); ++i) {
    sums_.beams.ranges_m[i] = 2U * sums_.agreeing[i] > sums_.returns[i]
                                  ? sums_.sums_m[i] / sums_.agreeing[i]
                                  : std::numeric_limits<float>::infinity();
  }
  return sums_.beams;
}

}  // namespace ribbon_mapper
