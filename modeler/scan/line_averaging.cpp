// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_averaging.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

/// Largest number of lines in an average; more occur only where the tilt stands still.
constexpr std::size_t kMaxLines = 16;

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
  if (lines_ == kMaxLines || (lines_ > 0 && !is_similar(beams, beams_))) lines_ = 0;
  if (lines_++ == 0) {
    start(beams, poses);
  } else {
    approach(beams, poses);
  }
  last_stamp_ = middle_of(beams);
  add_ranges(beams);
}

void LineAverager::start(const LaserBeams& beams, const LinePoses& poses) {
  beams_ = beams;
  poses_ = poses;
  sums_m_.assign(beams.ranges_m.size(), 0.0F);
  agreeing_.assign(beams.ranges_m.size(), 0);
  returns_.assign(beams.ranges_m.size(), 0);
}

/// Moves the mean stamp and the mean poses by the new line's share.
void LineAverager::approach(const LaserBeams& beams, const LinePoses& poses) {
  const double share = 1.0 / static_cast<double>(lines_);
  beams_.stamp += from_seconds(share * to_seconds(beams.stamp - beams_.stamp));
  for (Pose LinePoses::*pose :
       {&LinePoses::T_odom_base_first, &LinePoses::T_odom_base_last, &LinePoses::T_base_laser_first,
        &LinePoses::T_base_laser_last, &LinePoses::T_map_base}) {
    poses_.*pose = interpolate(poses_.*pose, poses.*pose, share);
  }
}

void LineAverager::add_ranges(const LaserBeams& beams) {
  const double limit_m = kSameSurfaceSigmas * config_.range_sigma_m;
  const bool same = has_same_beams(beams, beams_);
  for (std::size_t i = 0; i < sums_m_.size(); ++i) {
    const double bearing_rad =
        beams_.angle_min_rad + static_cast<double>(i) * beams_.angle_increment_rad;
    const float range_m = same ? beams.ranges_m[i] : range_at(beams, bearing_rad, config_);
    if (!is_return(range_m, beams, config_)) continue;
    ++returns_[i];
    if (agreeing_[i] > 0 && std::abs(range_m - sums_m_[i] / agreeing_[i]) > limit_m) continue;
    sums_m_[i] += range_m;
    ++agreeing_[i];
  }
}

const LaserBeams& LineAverager::average_beams() {
  for (std::size_t i = 0; i < sums_m_.size(); ++i) {
    beams_.ranges_m[i] = 2U * agreeing_[i] > returns_[i] ? sums_m_[i] / agreeing_[i]
                                                         : std::numeric_limits<float>::infinity();
  }
  return beams_;
}

}  // namespace ribbon_mapper
